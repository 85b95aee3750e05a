#pragma once

namespace proskill::worker {

/// The life of the process that verifies for the language server: reads a `WorkerJob` from standard
/// input, and writes a line of JSON for each of these to standard output: `{"progress": {…}}` a few
/// times a second, and at last `{"report": {…}}`, as docs/verify.schema.json has it, or
/// `{"error": "…"}`. Ends when its standard input does, when the process that started it does, and
/// when a limit is passed. Returns the exit code.
int runVerifyWorker();

} // namespace proskill::worker
