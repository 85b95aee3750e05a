#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/model/system.h"

namespace proskill::verify {

/// What an exploration need not look at.
struct Relevance {
  Bits cells;   ///< those that matter to a goal, or to what can happen
  Bits dropped; ///< transitions of the processes that are left out
};

/// The cone of influence of the goals: cells that nothing relevant reads are not told apart, and
/// processes that only watch are left out. Weiser, "Program slicing", TSE 1984; in timed nets a
/// process must also be unable to stop time. \throw LimitMet
[[nodiscard]] Relevance findRelevant(const System& system, const std::vector<Goal>& goals,
                                     LimitWatch& limits);

/// With nothing left out.
[[nodiscard]] Relevance everything(const System& system);

} // namespace proskill::verify
