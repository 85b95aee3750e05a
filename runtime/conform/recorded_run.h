#pragma once

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
  std::string stops; ///< the skill whose action is asked to stop in this step
};

/// A recorded run, without remarks.
struct RecordedRun {
  bool environment = false; ///< the environment of the program was executed, too
  std::vector<RecordedStep> steps;
};

/// The machine's last step in this form.
[[nodiscard]] RecordedStep recorded(const Executable& executable, const Machine& machine,
                                    verify::TransitionId step, Nanoseconds date);

} // namespace proskill::runtime
