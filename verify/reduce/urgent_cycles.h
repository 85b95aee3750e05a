#pragma once

#include "verify/limits.h"
#include "verify/model/system.h"

#include <vector>

namespace proskill::verify {

/// Whether an instance has a cycle of these paths.
/// \throw LimitMet
[[nodiscard]] bool hasCycle(const System& system, std::vector<PathId> paths, LimitWatch& limits);

/// Whether an instance can repeat some of these paths while no other instance moves. It cannot if
/// each cycle needs a condition and its negation. Such conditions read nothing that may change.
/// \param paths of one instance
/// \param changing cells that may change meanwhile
/// \return false: it cannot; true: perhaps
/// \throw LimitMet
[[nodiscard]] bool mayRepeatAlone(const System& system, std::vector<PathId> paths,
                                  const Bits& changing, LimitWatch& limits);

} // namespace proskill::verify
