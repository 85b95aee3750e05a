#pragma once

#include "verify/model/system.h"

#include <functional>

namespace proskill::verify {

/// Finds numbers that count places, as the number of users of a resource does: wherever an instance
/// is, the number has been changed by a constant on every way there. Such a number is its initial
/// value plus a constant for the location of each instance (a *place invariant*: Lautenbach,
/// "Exakte Bedingungen der Lebendigkeit für eine Klasse von Petri-Netzen", 1973). Assignments that
/// therefore keep it within its range are not `checked` any more, so their steps cannot fail. They
/// stop at the bounds of the range, since a slice of the system has more runs, in which the number
/// may be another.
/// \param system compiled, without a state layout
/// \param check called now and then; throws if a limit is met
void dropNeedlessChecks(System& system, const std::function<void()>& check);

} // namespace proskill::verify
