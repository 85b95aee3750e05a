#pragma once

#include "runtime/executor/observer.h"
#include "runtime/machine/machine.h"
#include "verify/verify.h"

#include <string>
#include <vector>

namespace proskill::runtime {

/// A recorded step: what happened, its place in the program, and the changes.
struct RecordedStep {
  Nanoseconds date = 0;
  fiacre::Origin what;
  std::vector<verify::Change> changes;
  std::string stops;        ///< the skill whose action is asked to stop in this step
  std::string message = ""; ///< what the step prints; empty: nothing
};

/// The recorded start of an action.
struct RecordedCall {
  std::size_t after = 0; ///< the number of steps before it
  Nanoseconds date = 0;
  std::string skill;
  std::string command; ///< empty: the program contains no such call
  std::vector<std::string> arguments;
};

/// What is known before a recorded run.
struct RecordedHead {
  std::string mainSkill;
  bool environment = false;            ///< the environment of the program was executed, too
  std::vector<verify::Change> initial; ///< in `after`; empty: not recorded
};

/// Receives a recorded run while it is read: its head, and then, in the order of the recording, its
/// steps and the starts of its actions. Other remarks are not passed on.
class RunSink {
public:
  RunSink() = default;
  RunSink(const RunSink&) = delete;
  RunSink& operator=(const RunSink&) = delete;
  virtual ~RunSink() = default;

  /// \return whether more is wanted, as of the others
  [[nodiscard]] virtual bool onHead(const RecordedHead& head) = 0;
  [[nodiscard]] virtual bool onStep(const RecordedStep& step) = 0;
  [[nodiscard]] virtual bool onCall(const RecordedCall& call) = 0;
};

/// A recorded run in memory.
struct RecordedRun {
  RecordedHead head;
  std::vector<RecordedStep> steps;
  std::vector<RecordedCall> calls; ///< in the order of the recording
};

/// Keeps a run in memory.
class KeptRun final : public RunSink {
public:
  bool onHead(const RecordedHead& head) override;
  bool onStep(const RecordedStep& step) override;
  bool onCall(const RecordedCall& call) override;

  RecordedRun run;
};

/// Passes on a run in memory. \return whether more was wanted
[[nodiscard]] bool replay(const RecordedRun& run, RunSink& to);
/// The same without its head.
[[nodiscard]] bool replaySteps(const RecordedRun& run, RunSink& to);

/// The machine's last step in this form.
[[nodiscard]] RecordedStep recorded(const Executable& executable, const Machine& machine,
                                    verify::TransitionId step, Nanoseconds date);

/// The start of an action in this form. \param after the number of steps before it
[[nodiscard]] RecordedCall recorded(const Executable& executable, const Start& start,
                                    Nanoseconds date, std::size_t after);

} // namespace proskill::runtime
