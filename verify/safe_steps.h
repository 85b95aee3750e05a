#pragma once

#include "verify/enabled.h"
#include "verify/goals.h"

namespace proskill::verify {

/// Partial order reduction.
class SafeSteps {
public:
  [[nodiscard]] TransitionId pick(const Word*, const TransitionSet&) const { return kNone; }
};

} // namespace proskill::verify
