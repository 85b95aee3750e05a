#pragma once

#include "verify/model/goals.h"
#include "verify/trace/dates.h"

#include <string>

namespace proskill::verify {

/// Runs the steps at their dates on concrete values and ages, and looks whether what the goal asks
/// for is seen at the end. It knows the transitions, but neither zones nor clocks nor reductions:
/// every transition has its own age. Returns what went wrong, empty where nothing did.
[[nodiscard]] std::string replay(const System& system, const Goal& goal, const Evidence& evidence,
                                 const Dating& dating);

} // namespace proskill::verify
