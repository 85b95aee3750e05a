#pragma once

#include "runtime/machine/machine.h"
#include "verify/verify.h"

namespace proskill::runtime {

/// The machine's last step as part of a trace, without its dates.
[[nodiscard]] verify::Step lastStep(const Executable& executable, const Machine& machine,
                                    verify::TransitionId step);

/// The skill whose action is asked to stop in the machine's last step; empty if there is none.
[[nodiscard]] std::string stoppingSkill(const Executable& executable, const Machine& machine);

/// The initial value of every watched variable, in `after`.
[[nodiscard]] std::vector<verify::Change> initialValues(const Executable& executable);

/// `(takeoff 3.0 0)`, or the skill's name if it has no `:action`.
[[nodiscard]] std::string commandText(const codegen::ActionCall* call, std::string_view skill);

} // namespace proskill::runtime
