#pragma once

#include "analysis/program/program.h"
#include "runtime/conform/recorded_run.h"

#include <expected>
#include <string>
#include <string_view>

namespace proskill::report {

/// Reads a recording written by `runRecording`. A truncated recording is read up to its last
/// complete step. The error is a message.
/// \param main receives the mission's name
[[nodiscard]] std::expected<runtime::RecordedRun, std::string>
readRecording(std::string_view text, const analysis::Program& program, std::string& main);

} // namespace proskill::report
