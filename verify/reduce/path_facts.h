#pragma once

#include "verify/model/system.h"

#include <map>

namespace proskill::verify {

/// What is surely written on every way through a path's code to an end, by target; the location
/// itself for `loop`.
[[nodiscard]] std::map<std::uint32_t, Bits> surelyWritten(const Path& path, const Bits& allCells);

/// Whether the transition may pass one of the events.
[[nodiscard]] bool mayPass(const System& system, const Transition& transition, const Bits& events);

/// Whether running the path may turn a condition on cells from false to true. A path that only
/// writes constants to the one cell of a condition does so only with one that makes it true. \pre
/// the system has a state layout
[[nodiscard]] bool mayMakeTrue(const System& system, const Path& path, NodeId condition);

/// Whether the condition is false after the path, wherever it ends: it writes constants to the
/// condition's one cell, and with none of them it holds. \param sure what the path surely writes
[[nodiscard]] bool makesFalse(const System& system, const Path& path, const Bits& sure,
                              NodeId condition);

} // namespace proskill::verify
