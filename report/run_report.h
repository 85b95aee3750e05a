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

/// A program, as it is executed. \pre both outlive whoever reports on a run
struct RunSubject {
  const analysis::Program& program;
  const runtime::Executable& executable;
};

/// A line a step, as traces have them, and one for each remark.
[[nodiscard]] std::unique_ptr<runtime::Observer> runText(std::ostream& out, RunSubject subject,
                                                         bool colour);
/// A JSON object a line.
[[nodiscard]] std::unique_ptr<runtime::Observer> runJson(std::ostream& out, RunSubject subject);

/// Gets what is added to a recording, and the end that closes it until more is added.
using AddToRecording = std::function<void(std::string_view bytes, std::string_view end)>;

/// A recording is a trace, as `proskill verify --save-traces` writes them, with remarks among its
/// steps. \param batch how many steps are added at once
[[nodiscard]] std::unique_ptr<runtime::Observer>
runRecording(AddToRecording add, RunSubject subject, std::size_t batch);

/// How a run ended: "the mission has ended".
[[nodiscard]] std::string_view toWords(runtime::End end);
void writeRunSummary(std::ostream& out, RunSubject subject, const runtime::RunResult& result,
                     bool colour);
void writeRunSummaryJson(std::ostream& out, const runtime::RunResult& result);

} // namespace proskill::report
