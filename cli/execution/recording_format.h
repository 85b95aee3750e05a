#pragma once

#include "cli/execution/recorder.h"
#include "report/run/run_report.h"

namespace proskill::cli {

/// Makes the observer that writes a run. \param start in nanoseconds since 1970; 0: in simulated
/// time
using WriteRun = std::function<std::unique_ptr<runtime::Observer>(report::RecordingSink sink,
                                                                  std::uint64_t start)>;

/// The format of a recording, by the extension of its file: `.mcap`, `.btlog`, or else a trace. The
/// error says why the run cannot have this format.
[[nodiscard]] std::expected<WriteRun, std::string> recordingFormat(const std::string& file,
                                                                   report::RunSubject subject);

/// The start of a run that begins now, in nanoseconds since 1970, to match other recordings of the
/// robot; 0 in simulated time.
[[nodiscard]] std::uint64_t startOfRun(RunTime time);

} // namespace proskill::cli
