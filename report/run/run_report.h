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

/// Receives bytes to append to a recording, and the end that closes it until more is appended. The
/// end is constant and may be kept.
using AddToRecording = std::function<void(std::string_view bytes, std::string_view end)>;

/// A file that also lets earlier bytes be replaced, after everything that was appended before.
struct RecordingSink {
  AddToRecording append;
  std::function<void(std::uint64_t at, std::string_view bytes)> replace;
};

/// Records a run as a trace, as `proskill verify --save-traces` writes it, with remarks among its
/// steps. Each step is added as soon as it happens.
[[nodiscard]] std::unique_ptr<runtime::Observer> runRecording(AddToRecording add,
                                                              RunSubject subject);

/// The trace of a run without its steps: its initial values, and what is known before it.
[[nodiscard]] OrderedJson runHeadJson(RunSubject subject);

/// Takes a step or a remark as a JSON object. \return false if there is no room for it
using PushLine = std::function<bool(std::string_view line)>;

/// Where the processes of a run may be in the program, for the `moves` of `runLive`: a list of
/// `{actor, performs, start, places}`. A process is at a statement of a body or performs an action;
/// otherwise its place is null.
[[nodiscard]] OrderedJson runPlacesJson(RunSubject subject);

/// Passes on a run line by line, in the form of `runRecording`. Each step also says which processes
/// have `moves`: pairs of a process and its place, by index. It never waits: where there is no
/// room, the next line that fits says how many are missing, and what they changed.
[[nodiscard]] std::unique_ptr<runtime::Observer> runLive(PushLine push, RunSubject subject);

/// Records a run as an MCAP file with channels of JSON: `/steps`, `/variables` and `/skills`, whose
/// statuses these are. Each chunk begins with all values. The observer's end completes the file.
/// \param start the run's beginning, in nanoseconds since 1970; 0: dates count from the beginning
/// \param chunkSize at which a chunk ends, in bytes
[[nodiscard]] std::unique_ptr<runtime::Observer>
runMcap(RecordingSink sink, RunSubject subject, std::uint64_t start,
        std::size_t chunkSize = std::size_t{1} << 20);

/// How a run ended: "the mission has ended".
[[nodiscard]] std::string_view toWords(runtime::End end);
void writeRunSummary(std::ostream& out, RunSubject subject, const runtime::RunResult& result,
                     bool colour);
void writeRunSummaryJson(std::ostream& out, RunSubject subject, const runtime::RunResult& result);
/// The program's own properties with what a run has decided: a list of `{name, description,
/// location, verdict, date, whyNot}`. \param verdicts empty: nothing is decided yet
[[nodiscard]] OrderedJson
runPropertiesJson(RunSubject subject,
                  const std::vector<runtime::PropertyMonitors::Decision>& verdicts);

} // namespace proskill::report
