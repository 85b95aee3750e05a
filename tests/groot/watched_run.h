#pragma once

#include "groot/statuses.h"
#include "runtime/executor/executor.h"

#include <set>
#include <string>

namespace proskill::test {

/// A program with its tree, and a run in simulated time that is watched.
class WatchedRun {
public:
  explicit WatchedRun(const std::string& text);
  /// Whether a program can be watched.
  [[nodiscard]] static bool isPossible(const std::string& text);

  /// \param afterStep is called with the statuses after each step, its date and the state
  using AfterStep = std::function<void(const groot::Statuses&, runtime::Nanoseconds,
                                       const std::vector<verify::Word>&)>;
  runtime::RunResult run(const AfterStep& afterStep, std::uint64_t seed = 0,
                         const std::string& script = {}, double until = 600);

  /// The uids of the nodes with this tag, in order.
  [[nodiscard]] std::vector<groot::Uid> tagged(std::string_view tag) const;
  /// The changes of the nodes with this tag: `2.5 7 success`, one a line.
  [[nodiscard]] std::string changesOf(std::string_view tag, const std::string& script = {});

  analysis::Program program;
  std::unique_ptr<const runtime::Executable> executable;
  groot::Tree tree;
};

/// Passes on the steps of a run. \pre the run ends with the function
class Watcher final : public runtime::Observer {
public:
  using Step = std::function<void(const runtime::Machine&, runtime::Nanoseconds)>;
  explicit Watcher(Step to) : step(std::move(to)) {}
  void onStep(const runtime::Machine& machine, verify::TransitionId, runtime::Nanoseconds date,
              runtime::Nanoseconds) override {
    step(machine, date);
  }
  void onRemark(const runtime::Remark&) override {}

private:
  const Step step;
};

/// Executes in simulated time. \param script JSON, may be empty
runtime::RunResult execute(const runtime::Executable& executable, runtime::Observer& observer,
                           std::uint64_t seed, const std::string& script = {}, double until = 600);

} // namespace proskill::test
