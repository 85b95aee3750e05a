#pragma once

#include "verify/model/goals.h"

#include <optional>
#include <string>

namespace proskill::verify {

/// Why other model checkers are not asked for a goal. \return nothing if it is a state or a step,
/// so that any model checker can search for it
[[nodiscard]] std::optional<std::string> whyNotAsked(const Goal& goal);

} // namespace proskill::verify
