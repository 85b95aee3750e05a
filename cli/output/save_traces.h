#pragma once

#include "report/verify_report.h"

#include <filesystem>
#include <optional>
#include <string>

namespace proskill::cli {

/// Writes each trace of the report to `directory` as `PROPERTY.json` and `PROPERTY.txt`. The
/// directory is created if missing. Returns an error message, or nothing.
[[nodiscard]] std::optional<std::string> saveTraces(const std::filesystem::path& directory,
                                                    const report::VerifyReport& report);

} // namespace proskill::cli
