#pragma once

#include "verify/model/system.h"

#include <string>
#include <vector>

namespace proskill::verify {

/// A name for each transition that mostly survives changes of the model elsewhere: its instances,
/// their locations, and which of the steps from there it is.
[[nodiscard]] std::vector<std::string> stepNames(const System& system);

} // namespace proskill::verify
