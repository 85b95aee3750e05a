#pragma once

#include "runtime/machine/executable.h"
#include "runtime/platform/ros_words.h"

namespace proskill::runtime {

/// Reads the topics of the members `variables` and `events`. Throws `Wrong`.
/// \return the list of their mappings in terms of the adapters: names of events
[[nodiscard]] Json rosSensors(const analysis::Program& program, const Json& file, Ros ros);

} // namespace proskill::runtime
