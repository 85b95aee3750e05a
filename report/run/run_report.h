#pragma once

#include "analysis/program/program.h"
#include "ide/verdicts/verification.h"
#include "report/ordered_json.h"
#include "runtime/executor/executor.h"

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>

/// The output of `proskill run` during a run.
namespace proskill::report {

/// An executed program. \pre both outlive the observers of the run
struct RunSubject {
  const analysis::Program& program;
  const runtime::Executable& executable;
};

/// One line per step, as in traces, and one per remark.
[[nodiscard]] std::unique_ptr<runtime::Observer> runText(std::ostream& out, RunSubject subject,
                                                         bool colour);
/// One JSON object per line.
[[nodiscard]] std::unique_ptr<runtime::Observer> runJson(std::ostream& out, RunSubject subject);

/// Receives bytes to append to a recording, and the end that closes it until more is appended.
using AddToRecording = std::function<void(std::string_view bytes, std::string_view end)>;

/// Records a run as a trace, as `proskill verify --save-traces` writes it, with remarks among its
/// steps. Each step is added as soon as it happens.
[[nodiscard]] std::unique_ptr<runtime::Observer> runRecording(AddToRecording add,
                                                              RunSubject subject);

/// Records a run as an MCAP file with channels of JSON: `/steps`, `/variables` and `/skills`, whose
/// statuses these are.
/// \param start the run's beginning, in nanoseconds since 1970; 0: dates count from the beginning
[[nodiscard]] std::unique_ptr<runtime::Observer> runMcap(AddToRecording add, RunSubject subject,
                                                         std::uint64_t start);

/// How a run ended: "the mission has ended".
[[nodiscard]] std::string_view toWords(runtime::End end);
void writeRunSummary(std::ostream& out, RunSubject subject, const runtime::RunResult& result,
                     bool colour);
void writeRunSummaryJson(std::ostream& out, const runtime::RunResult& result);

} // namespace proskill::report
