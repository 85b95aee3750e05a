#pragma once

#include "verify/limits.h"
#include "verify/model/system.h"

#include <vector>

namespace proskill::verify {

/// A system with a step for each way through the code of a step.
struct SplitSystem {
  System system; ///< cells, instances, events and clocks as in the whole; nodes are added
  std::vector<TransitionId> original; ///< by transition: its index in the whole system
};

/// Makes tests in the code of steps conditions of these steps, so that slices may omit them. Only
/// of steps without a clock, since a clock depends on when its step is possible, and of tests that
/// read the state before the step. \param whole without a state layout, and without priorities
/// \throw LimitMet
[[nodiscard]] SplitSystem withSplitTests(const System& whole, LimitWatch& limits);

} // namespace proskill::verify
