#pragma once

#include "record/run_recording.h"

namespace proskill::cli {

/// The format of a recording, by the extension of its file: `.btlog`, or those of
/// record::formatOf. The error says why the run cannot have this format.
[[nodiscard]] std::expected<record::WriteRun, std::string>
recordingFormat(const std::string& file, report::RunSubject subject);

} // namespace proskill::cli
