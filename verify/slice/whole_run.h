#pragma once

#include "verify/trace/dates.h"

namespace proskill::verify {

/// What the whole system does along a run of a slice.
struct WholeRun {
  Steps steps;
  bool isRun = false; ///< whether the whole can take the steps; otherwise they are a plan
};

/// Takes the steps of a slice's run at their dates, and adds other steps if time could not pass
/// without them, as late as possible. If the run exists in the slice only, the steps are those that
/// the whole can take, which lead on past where it leaves the run, and the others after them.
/// \param whole the system with every cell kept
/// \param steps of the run, in the whole
/// \param planned transitions of the whole that a run does not add
/// \param dating of the steps in the slice
/// \param mostOfPlan how many steps are taken for a plan
/// \throw LimitMet
[[nodiscard]] WholeRun wholeRun(const System& whole, const Steps& steps, const Bits& planned,
                                const Dating& dating, std::size_t mostOfPlan, LimitWatch& limits);

} // namespace proskill::verify
