#pragma once

#include "runtime/machine/executable.h"
#include "runtime/platform/ros_words.h"

namespace proskill::runtime {

/// Reads what performs a skill's action: a goal, a service or a topic. Throws `Wrong`.
/// \return the mapping in terms of the adapters: positions of arguments, lists of cases
[[nodiscard]] Json rosAction(const analysis::Program& program, const codegen::Performed& performed,
                             const Json& value, Ros ros);

} // namespace proskill::runtime
