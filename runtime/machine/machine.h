#pragma once

#include "runtime/machine/executable.h"
#include "runtime/machine/random.h"
#include "verify/state/run.h"

namespace proskill::runtime {

/// State of a run, and since when each timed step has been enabled. It knows the possible steps;
/// its owner decides when they are taken. After construction it allocates only when its log grows
/// to the longest step so far.
class Machine {
public:
  /// \pre the executable outlives this
  Machine(const Executable& of, std::uint64_t seed);

  /// A random step among those that must be taken before time passes.
  [[nodiscard]] std::optional<verify::TransitionId> urgent();

  struct Due {
    verify::TransitionId transition = 0;
    Nanoseconds date = 0;
  };
  /// The timed step with the earliest date.
  [[nodiscard]] std::optional<Due> due() const;

  /// The step that is possible now through this port.
  [[nodiscard]] std::optional<verify::TransitionId> at(std::uint32_t port) const;

  /// Takes a step.
  /// \return false if it fails, which is an error of the model; the state is then invalid
  /// \pre the step is enabled
  bool take(verify::TransitionId step, Nanoseconds date);

  [[nodiscard]] const std::vector<verify::Word>& state() const { return now; }
  /// The state before the last step.
  [[nodiscard]] const std::vector<verify::Word>& stateBefore() const { return before; }
  /// The log of the last step.
  [[nodiscard]] const verify::StepLog& log() const { return passed; }
  [[nodiscard]] std::int64_t location(verify::InstanceId instance) const;
  [[nodiscard]] std::int64_t locationBefore(verify::InstanceId instance) const;

private:
  void setDates(verify::TransitionId step, Nanoseconds date);
  /// The date of a step that is enabled from now on.
  [[nodiscard]] Nanoseconds dateOf(verify::TransitionId step, Nanoseconds date);

  const Executable& executable;
  const verify::System& system;
  const verify::Enabling& enabling;
  Random random;
  verify::TransitionSet urgentOnes; ///< among the program's own steps
  verify::TransitionSet timedOnes;
  verify::TransitionSet enabled;
  verify::TransitionSet timedBefore; ///< timed steps that were enabled before the step
  std::vector<Nanoseconds> dates;    ///< due date of each enabled timed step
  std::vector<Nanoseconds> taken;    ///< when each step was last taken; -1: never
  std::vector<verify::Word> now;
  std::vector<verify::Word> before;
  verify::StepLog passed;
};

} // namespace proskill::runtime
