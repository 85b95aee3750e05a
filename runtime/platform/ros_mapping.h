#pragma once

#include "runtime/machine/executable.h"
#include "runtime/platform/ros_words.h"

/// The parts of a platform file of kind `ros1` or `ros2`, in terms of the adapters.
namespace proskill::runtime {

/// Reads what performs a skill's action: a goal, a service or a topic. Notes and throws what is
/// wrong.
/// \return its mapping: positions of arguments, lists of cases
[[nodiscard]] Json rosAction(const analysis::Program& program, const codegen::Performed& performed,
                             const Json& value, Ros ros, Errors& errors);

/// Reads the topics of the members `variables` and `events`, and notes what is wrong.
/// \return the list of their mappings: names of events
[[nodiscard]] Json rosSensors(const analysis::Program& program, const Json& file, Ros ros,
                              Errors& errors);

} // namespace proskill::runtime
