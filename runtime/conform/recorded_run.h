#pragma once

#include "runtime/machine/machine.h"
#include "verify/verify.h"

#include <string>
#include <vector>

namespace proskill::runtime {

/// A step as it was recorded: what happened, where the program says it, and what it changed.
struct RecordedStep {
  Nanoseconds date = 0;
  fiacre::Origin what;
  std::vector<verify::Change> changes;
  std::string stops; ///< the skill that asks its action to stop in this step
};

/// A run as it was recorded, without remarks.
struct RecordedRun {
  bool environment = false; ///< the program's own environment was executed, too
  std::vector<RecordedStep> steps;
};

/// The machine's last step.
[[nodiscard]] RecordedStep recorded(const Executable& executable, const Machine& machine,
                                    verify::TransitionId step, Nanoseconds date);

} // namespace proskill::runtime
