#pragma once

#include "tina/tools.h"

namespace proskill::tina {

/// The first line of the help of each tool, for reports: `sift: Sift version
/// 3.8.5 …`. A tool without output within five seconds is named with its path alone.
[[nodiscard]] std::vector<std::string> versions(const Tools& tools);

} // namespace proskill::tina
