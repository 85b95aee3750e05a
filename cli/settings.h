#pragma once

#include "analysis/flow/inspect.h"

#include <expected>
#include <filesystem>
#include <string>

namespace proskill::cli {

/// What the file `.proskill.json` beside a program's root file, or in the nearest directory above,
/// says about findings; see docs/proskill.schema.json. Nothing is said where there is none. An
/// error is a sentence for the user, with the path.
[[nodiscard]] std::expected<analysis::flow::Settings, std::string>
settingsFor(const std::filesystem::path& root);

} // namespace proskill::cli
