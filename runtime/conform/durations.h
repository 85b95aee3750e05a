#pragma once

#include "runtime/conform/recorded_run.h"

#include <map>
#include <string>

namespace proskill::runtime {

/// How long the actions of a basic skill took in recorded runs, without those that were stopped.
struct Durations {
  Nanoseconds least = 0;
  Nanoseconds most = 0;
  std::size_t count = 0;
};

/// Collects the durations of actions while runs are read.
class DurationsOfRuns final : public RunSink {
public:
  /// \pre the program outlives this
  explicit DurationsOfRuns(const analysis::Program& of) : program(of) {}

  bool onHead(const RecordedHead& head) override;
  bool onStep(const RecordedStep& step) override;
  bool onCall(const RecordedCall& call) override;
  /// By skill; a skill whose action has never ended by itself is missing.
  [[nodiscard]] const std::map<std::string, Durations>& all() const { return durations; }

private:
  const analysis::Program& program;
  std::map<std::string, Nanoseconds> since; ///< by skill: when its action has started
  std::map<std::string, Durations> durations;
};

/// The interval of a skill, widened so that it includes durations: `[1,3.5]`. A bound that changes
/// is rounded outwards to two digits. Empty if the interval includes them.
[[nodiscard]] std::string widened(const syntax::Interval& interval, const Durations& durations);

} // namespace proskill::runtime
