#pragma once

#include "report/verify_report.h"

#include <filesystem>
#include <optional>
#include <string>

namespace proskill::cli {

/// Writes each trace of the report as `PROPERTY.json` and `PROPERTY.txt` into `directory`, which is
/// made where it is missing. What could not be written, in words, or nothing.
[[nodiscard]] std::optional<std::string> saveTraces(const std::filesystem::path& directory,
                                                    const report::VerifyReport& report);

} // namespace proskill::cli
