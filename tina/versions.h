#pragma once

#include "tina/tools.h"

namespace proskill::tina {

/// The first line that each tool says when it is asked for help, for reports: `sift: Sift version
/// 3.8.5 …`. A tool that says nothing within five seconds is named with its path alone.
[[nodiscard]] std::vector<std::string> versions(const Tools& tools);

} // namespace proskill::tina
