#pragma once

#include <string>

namespace proskill::cache {

/// The digest of the running executable, since another build may decide or number differently.
/// Empty if it cannot be read.
[[nodiscard]] const std::string& digestOfThisProgram();

} // namespace proskill::cache
