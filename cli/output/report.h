#pragma once

#include "report/verify_report.h"

#include <filesystem>
#include <optional>
#include <string>

namespace proskill::cli {

/// Writes `index.html` into the directory, which is made: verdicts, traces, texts and pictures in
/// one page that needs nothing else. What went wrong, if something did.
[[nodiscard]] std::optional<std::string> writeReport(const std::filesystem::path& directory,
                                                     const report::VerifyReport& report);

} // namespace proskill::cli
