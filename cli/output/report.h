#pragma once

#include "report/verify_report.h"

#include <filesystem>
#include <optional>
#include <string>

namespace proskill::cli {

/// Writes `index.html` to the directory, which is created if missing: verdicts, traces, texts and
/// pictures in one self-contained page. Returns an error message, or nothing.
[[nodiscard]] std::optional<std::string> writeReport(const std::filesystem::path& directory,
                                                     const report::VerifyReport& report);

} // namespace proskill::cli
