#pragma once

#include "runtime/conform/recorded_run.h"

#include <memory>
#include <optional>

namespace proskill::runtime {

enum class Conformance : std::uint8_t {
  Conforms,
  Deviates, ///< no run of the model has these steps at these dates
  Unknown,  ///< too many runs to follow, or the environment may have taken steps that are not
            ///< recorded
};

/// Whether a recorded run is a run of the model.
struct ConformResult {
  Conformance verdict = Conformance::Conforms;
  /// Deviates, Unknown: the first step that no run explains; the number of steps if what is
  /// recorded after them is wrong.
  std::size_t step = 0;
  std::optional<RecordedStep> at; ///< that step; nullopt if there is none
  std::string why;                ///< the reason, for users
  std::string assumption;         ///< the assumption of the model that was violated, if known
  bool isElsewhere = false;       ///< only the place of the step is wrong
};

struct ConformOptions {
  /// How far actions and events may be outside their intervals.
  Nanoseconds tolerance = 0;
  /// Whether steps have to be at the same places of the program, which edits move.
  bool placesMatter = true;
};

/// Follows a recorded run, while it is read, through all runs of the verified model that have the
/// same steps at the same dates. Steps that a recording does not contain (watchdogs; the
/// environment, unless it was executed) may happen in between. Initial values, messages and the
/// calls of actions have to be those of the program. The memory does not grow with the run.
class RunJudge final : public RunSink {
public:
  /// \pre the program outlives this
  RunJudge(const analysis::Program& of, const ConformOptions& by);
  ~RunJudge() override;

  bool onHead(const RecordedHead& head) override;
  /// \return whether the verdict may still change, as of the others
  bool onStep(const RecordedStep& step) override;
  bool onCall(const RecordedCall& call) override;
  /// The verdict on what was read until now; where the run conforms, `step` is the number of steps.
  /// The error: there is no model of this mission. \pre it has a head
  [[nodiscard]] std::expected<ConformResult, NotExecutable> result() const;

private:
  class WithModel;

  const analysis::Program& program;
  ConformOptions options;
  std::expected<std::unique_ptr<WithModel>, NotExecutable> judge;
};

/// Judges a run in memory.
[[nodiscard]] std::expected<ConformResult, NotExecutable>
conform(const analysis::Program& program, const RecordedRun& run, const ConformOptions& options);

} // namespace proskill::runtime
