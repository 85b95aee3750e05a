#pragma once

#include "tina/tools.h"

namespace proskill::tina {

/// The first line of each tool's help, for reports: `sift: Sift version 3.8.5 …`. For a tool
/// without output within five seconds, only its path.
[[nodiscard]] std::vector<std::string> versions(const Tools& tools);

} // namespace proskill::tina
