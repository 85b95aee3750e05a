#pragma once

#include "runtime/machine/machine.h"
#include "verify/verify.h"

namespace proskill::runtime {

/// The machine's last step as a trace has it, without its dates.
[[nodiscard]] verify::Step lastStep(const Executable& executable, const Machine& machine,
                                    verify::TransitionId step);

/// The skill that asks its action to stop in the machine's last step; empty where none does.
[[nodiscard]] std::string stoppingSkill(const Executable& executable, const Machine& machine);

/// Every watched variable's value at the start, in `after`.
[[nodiscard]] std::vector<verify::Change> initialValues(const Executable& executable);

/// `(takeoff 3.0 0)`, or the skill's name where it has no `:action`.
[[nodiscard]] std::string commandText(const codegen::ActionCall* call, std::string_view skill);

} // namespace proskill::runtime
