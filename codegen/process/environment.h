#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// The process of an event: when its port is taken, it applies the event's effects.
[[nodiscard]] fiacre::Process eventProcess(Context& context,
                                           const analysis::Definition<syntax::Event>& event);

/// Whether the model itself makes the event occur according to its `:every`, rather than an
/// environment or a platform.
[[nodiscard]] bool comesByItself(const Context& context, const syntax::Event& event);

/// The ports of all events that do not occur by themselves, then those of all interrupts from
/// outside.
[[nodiscard]] std::vector<std::string> environmentPorts(Context& context);

/// The ports of the events that occur by themselves, with the time between two occurrences.
[[nodiscard]] std::vector<fiacre::Port> everyPorts(Context& context);

/// The process that takes these ports: the program's environment, or one that takes any port at any
/// time.
/// \pre the model is to be verified
[[nodiscard]] fiacre::Process environmentProcess(Context& context);

/// For a library without a mission: a process that calls any free basic skill at any time.
[[nodiscard]] fiacre::Process generalCaller(Context& context);

} // namespace proskill::codegen
