#pragma once

#include "verify/state/timing.h"

#include <optional>
#include <vector>

namespace proskill::verify {

/// The values of the clocks after some steps, over all dates of the steps.
struct ExactZone {
  std::vector<ClockId> clocks; ///< in the order of the matrix
  Dbm zone;
};

/// Computes the zones along steps from the initial state, extrapolated only as far as that is
/// exact. Nothing if the steps are not possible.
/// \param dropped transitions that are skipped
/// \param between called between parts of operations on many clocks; may throw
[[nodiscard]] std::optional<ExactZone> exactZone(const System& system,
                                                 const std::vector<TransitionId>& steps,
                                                 const Between& between, const Bits& dropped = {});

} // namespace proskill::verify
