#pragma once

#include "analysis/program/program.h"
#include "report/run/mcap.h"
#include "runtime/conform/recorded_run.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::report {

/// Name of the metadata record in which an MCAP file has the trace without its steps.
inline constexpr std::string_view kTraceHead = "proskill.trace";
/// Topics of the values. A skill has its status, which is the variable with this suffix in a trace.
inline constexpr std::string_view kVariablesTopic = "/variables";
inline constexpr std::string_view kSkillsTopic = "/skills";
inline constexpr std::string_view kStatusSuffix = ".status";

/// The text of a trace. \param head its JSON object without steps, which is not empty
[[nodiscard]] std::string traceWith(std::string head, const std::vector<std::string_view>& steps);

/// The trace without its steps, if it has a step in each line, as it is recorded. \param firstLine
/// of the file
[[nodiscard]] std::optional<std::string> headOfLines(std::string_view firstLine);

/// The text of a recording that was cut off, as a trace up to its last complete step; as it is if
/// that is not possible. A recording has a step in each line.
[[nodiscard]] std::string completed(std::string_view text);

/// Reads a recording written by `runRecording` or `runMcap`, step by step, so that its size does
/// not matter. A truncated recording is read up to its last complete step. \return an error
/// message, or nothing; `to` may have got a part of the run
[[nodiscard]] std::optional<std::string>
readRecording(const mcap::File& recording, const analysis::Program& program, runtime::RunSink& to);

} // namespace proskill::report
