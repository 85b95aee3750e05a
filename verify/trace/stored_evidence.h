#pragma once

#include "verify/explore/search.h"
#include "verify/model/goals.h"

namespace proskill::verify {

/// Whether stored evidence can be replayed: it refers only to what exists. Nothing is assumed of
/// it, as it may come from anywhere.
[[nodiscard]] bool canBeReplayed(const Evidence& evidence, const Goal& goal, const System& system);

} // namespace proskill::verify
