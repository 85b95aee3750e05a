#pragma once

#include <string>

namespace proskill::worker {

/// Main function of the process that verifies for the language server. Reads a `WorkerJob` from
/// standard input, and writes these lines of JSON to standard output:
/// - `{"begin": {…}}`: the report in the format of docs/verify.schema.json, with nothing decided;
/// - `{"progress": {…}}` a few times a second;
/// - `{"decided": {"index": …, "property": {…}}}` for each verdict; it replaces the report's entry;
/// - finally `{"report": {…}}`, with null for properties that were sent before,
///   `{"stopped": "…"}` if it cannot continue, or `{"error": "…"}`.
/// Ends when its standard input ends, when the process that started it ends, or when a limit is
/// met. Returns the exit code.
/// \param cache the directory of stored verdicts; empty: none are stored
int runVerifyWorker(const std::string& cache);

} // namespace proskill::worker
