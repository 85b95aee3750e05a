#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// The process of an event: when its port is taken, its effects are set.
[[nodiscard]] fiacre::Process eventProcess(Context& context,
                                           const analysis::Definition<syntax::Event>& event);

/// It has `:every`, and the model has it come: no environment and no platform does.
[[nodiscard]] bool comesByItself(const Context& context, const syntax::Event& event);

/// The ports of all events that do not come by themselves, then those of all interrupts from
/// outside.
[[nodiscard]] std::vector<std::string> environmentPorts(Context& context);

/// Those of the events that come by themselves, with the time between two occurrences.
[[nodiscard]] std::vector<fiacre::Port> everyPorts(Context& context);

/// Who takes the ports: the program's environment, or one that takes any of them at any time.
/// \pre offline
[[nodiscard]] fiacre::Process environmentProcess(Context& context);

/// Of a library without a mission: calls any basic skill that is free, at any time.
[[nodiscard]] fiacre::Process generalCaller(Context& context);

} // namespace proskill::codegen
