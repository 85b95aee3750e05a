#pragma once

#include "verify/model/system.h"

#include <map>

namespace proskill::verify {

/// The targets of a path; the location itself if it loops.
[[nodiscard]] std::vector<std::uint32_t> targetsOf(const Path& path);

/// The cells that every way through a path's code surely writes, by the location in which it ends;
/// `loop` ends in its own location.
[[nodiscard]] std::map<std::uint32_t, Bits> surelyWritten(const Path& path, const Bits& allCells);

/// Whether the transition may cause one of the events.
[[nodiscard]] bool mayPass(const System& system, const Transition& transition, const Bits& events);

/// Whether the path may make a condition on cells true. If the path only writes constants to the
/// condition's single cell, the condition is evaluated with these constants. \pre the system has a
/// state layout
[[nodiscard]] bool mayMakeTrue(const System& system, const Path& path, NodeId condition);

/// Whether the condition is false after the path, wherever it ends: the path surely writes the
/// condition's single cell, only constants, and none of them satisfies the condition.
/// \param sure cells that the path surely writes
[[nodiscard]] bool makesFalse(const System& system, const Path& path, const Bits& sure,
                              NodeId condition);

} // namespace proskill::verify
