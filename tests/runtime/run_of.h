#pragma once

#include "runtime/conform/recorded_run.h"
#include "runtime/executor/executor.h"
#include "runtime/platform/simulated.h"

#include <memory>
#include <string>
#include <vector>

namespace proskill::test {

/// Everything that happened in a run.
struct Ran {
  struct Taken {
    verify::TransitionId step = 0;
    runtime::Nanoseconds date = 0;
    std::string actor;
    std::string description;
  };
  struct Told {
    runtime::RemarkKind kind = runtime::RemarkKind::Note;
    runtime::Nanoseconds date = 0;
    std::string subject;
    std::string text;
  };
  runtime::RunResult result;
  std::vector<Taken> steps;
  std::vector<Told> remarks;
  runtime::RecordedRun recorded;
  runtime::Nanoseconds maxLag = 0;

  /// `2.5 fly succeeds with `there``, one step per line.
  [[nodiscard]] std::string text() const;
  /// The date at which an actor does something for the first time, in seconds; -1: never.
  [[nodiscard]] double when(std::string_view actor, std::string_view description) const;
  [[nodiscard]] const Told* told(runtime::RemarkKind kind) const;
};

[[nodiscard]] std::unique_ptr<const runtime::Executable> executableOf(const std::string& text,
                                                                      bool environment = true);

/// Runs a program in simulated time. \param script JSON, may be empty \param platform likewise
[[nodiscard]] Ran runOf(const runtime::Executable& executable, std::uint64_t seed,
                        const std::string& script = {}, const std::string& platform = {},
                        double until = 600);
[[nodiscard]] Ran runOf(const runtime::Executable& executable, runtime::Platform& platform,
                        runtime::RunOptions options);
/// With the real clock: dates depend on the machine.
[[nodiscard]] Ran runInRealTime(const runtime::Executable& executable, runtime::Platform& platform,
                                runtime::RunOptions options);
/// With a clock of the test.
[[nodiscard]] Ran runOf(const runtime::Executable& executable, runtime::Platform& platform,
                        runtime::Clock& clock, runtime::RunOptions options);
/// Events and interrupts only as the script says.
[[nodiscard]] Ran runOf(const std::string& text, const std::string& script = R"({"signals":[]})",
                        std::uint64_t seed = 0);

} // namespace proskill::test
