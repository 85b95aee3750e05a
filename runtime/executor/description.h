#pragma once

#include "runtime/executor/observer.h"
#include "runtime/monitor/property_monitors.h"
#include "verify/verify.h"

namespace proskill::runtime {

/// The machine's last step as part of a trace, without its dates.
[[nodiscard]] verify::Step lastStep(const Executable& executable, const Machine& machine,
                                    verify::TransitionId step);

/// The action that is asked to stop in the machine's last step; nullopt if there is none.
[[nodiscard]] std::optional<std::uint32_t> stoppingAction(const Executable& executable,
                                                          const Machine& machine);

/// The initial value of every watched variable, in `after`.
[[nodiscard]] std::vector<verify::Change> initialValues(const Executable& executable);

/// The status of the mission, such as `success`; empty if there is no mission.
[[nodiscard]] std::string missionStatus(const Executable& executable, const Machine& machine);

/// The message that the machine's last step prints, with its values; nullopt: it prints none.
[[nodiscard]] std::optional<std::string> printedMessage(const Executable& executable,
                                                        const Machine& machine);

/// A decision about one of the program's properties. \pre it is decided
[[nodiscard]] Remark remarkOf(const Executable& executable,
                              const PropertyMonitors::Decision& decision);

/// An alarm of the program in a step. \pre the executable has an alarm of this origin
[[nodiscard]] Remark alarmOf(const Executable& executable, fiacre::OriginId origin,
                             Nanoseconds date);

/// Why a signal from the platform has no effect now.
[[nodiscard]] const char* whyIgnored(const codegen::Model& model, const codegen::Signal& signal);

/// `(takeoff 3.0 0)`, or the skill's name if it has no `:action`.
[[nodiscard]] std::string commandText(const codegen::ActionCall* call, std::string_view skill);

} // namespace proskill::runtime
