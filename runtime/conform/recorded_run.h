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

/// A recorded run, without remarks other than the starts of actions.
struct RecordedRun {
  bool environment = false;            ///< the environment of the program was executed, too
  std::vector<verify::Change> initial; ///< in `after`; empty: not recorded
  std::vector<RecordedStep> steps;
  std::vector<RecordedCall> calls; ///< in the order of the recording
};

/// The machine's last step in this form.
[[nodiscard]] RecordedStep recorded(const Executable& executable, const Machine& machine,
                                    verify::TransitionId step, Nanoseconds date);

/// The start of an action in this form. \param after the number of steps before it
[[nodiscard]] RecordedCall recorded(const Executable& executable, const Start& start,
                                    Nanoseconds date, std::size_t after);

} // namespace proskill::runtime
