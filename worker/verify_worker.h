#pragma once

#include <string>

namespace proskill::worker {

/// Main function of the process that verifies for the language server: reads a `WorkerJob` from
/// standard input, and writes a line of JSON for each of these to standard output:
/// - `{"begin": {…}}`: the report, as docs/verify.schema.json has it, with nothing decided;
/// - `{"progress": {…}}` a few times a second;
/// - `{"decided": {"index": …, "property": {…}}}` with each verdict, in place of that of the
/// report;
/// - at last `{"report": {…}}`, with null for properties that were sent before,
///   `{"stopped": "…"}` if it cannot continue, or `{"error": "…"}`.
/// \param cache the directory where verdicts are kept; empty: none are
/// Ends when its standard input does, when the process that started it does, and
/// when a limit is passed. Returns the exit code.
int runVerifyWorker(const std::string& cache);

} // namespace proskill::worker
