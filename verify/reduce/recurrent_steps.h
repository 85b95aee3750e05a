#pragma once

#include "verify/limits.h"
#include "verify/model/system.h"
#include "verify/state/transition_set.h"

namespace proskill::verify {

/// A superset of the urgent transitions that may fire infinitely often while no time passes and
/// nothing optional happens. Any other transition then fires finitely often. This includes clocked
/// transitions, whose clocks need time to reach their bounds again. The set is the fixed point of
/// removing transitions
/// - that are on no cycle of their instance's locations,
/// - that need a variable to have a value that none of the remaining ones would set again, or
/// - that need different values of a variable that none of the remaining ones changes.
/// Transitions that may fail, or whose code may turn out to be disabled, are never removed.
/// \throw LimitMet
[[nodiscard]] TransitionSet recurrentSteps(const System& system, const Bits& dropped,
                                           LimitWatch& limits);

} // namespace proskill::verify
