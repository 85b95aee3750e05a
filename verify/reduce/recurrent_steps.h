#pragma once

#include "verify/limits.h"
#include "verify/model/system.h"
#include "verify/state/transition_set.h"

namespace proskill::verify {

/// The urgent transitions that may happen again and again without end while no time passes and
/// nothing happens that need not; a superset. What is not among them happens finitely often then: a
/// clocked step among others, since its clock needs time to come to its bound again. Found by
/// taking away, until nothing changes,
/// - what lies on no cycle of its instance's locations;
/// - what needs a variable to have a value that none of those left would give it again, and those
///   that need different values of a variable that none of them changes.
/// Steps that may fail or may turn out to be impossible are always among them. \throw LimitMet
[[nodiscard]] TransitionSet recurrentSteps(const System& system, const Bits& dropped,
                                           LimitWatch& limits);

} // namespace proskill::verify
