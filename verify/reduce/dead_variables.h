#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/model/system.h"

namespace proskill::verify {

/// The part of a system that an exploration needs.
struct Relevance {
  Bits cells;   ///< cells that affect a goal or the possible steps
  Bits dropped; ///< transitions of processes that are skipped
};

/// Computes the cone of influence of the goals. Cells that nothing relevant reads do not
/// distinguish states, and processes that only observe are skipped. Weiser, "Program slicing", TSE
/// 1984; in a timed net a skipped process must also be unable to stop time.
/// \throw LimitMet
[[nodiscard]] Relevance findRelevant(const System& system, const std::vector<Goal>& goals,
                                     LimitWatch& limits);

/// All cells; no transition is skipped.
[[nodiscard]] Relevance everything(const System& system);

} // namespace proskill::verify
