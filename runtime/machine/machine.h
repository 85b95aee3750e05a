#pragma once

#include "runtime/machine/executable.h"
#include "runtime/machine/random.h"
#include "verify/state/run.h"

namespace proskill::runtime {

/// A run of a program: its state, and since when each step with a time has been possible. It knows
/// which steps there are; somebody else says when they are taken. Nothing is allocated after it was
/// made, but for the lists of its log, which grow to the longest step and stay.
class Machine {
public:
  /// \pre the executable outlives this
  Machine(const Executable& of, std::uint64_t seed);

  /// A step that has to be taken before time passes: one of them, drawn.
  [[nodiscard]] std::optional<verify::TransitionId> urgent();

  struct Due {
    verify::TransitionId transition = 0;
    Nanoseconds date = 0;
  };
  /// The step whose time comes first.
  [[nodiscard]] std::optional<Due> due() const;

  /// The step by which this port is passed now.
  [[nodiscard]] std::optional<verify::TransitionId> at(std::uint32_t port) const;

  /// Takes a step; false where it fails, which is an error of the model: the state is spoilt then.
  /// \pre it is enabled
  bool take(verify::TransitionId step, Nanoseconds date);

  [[nodiscard]] const std::vector<verify::Word>& state() const { return now; }
  /// Before the last step.
  [[nodiscard]] const std::vector<verify::Word>& stateBefore() const { return before; }
  /// What the last step passed.
  [[nodiscard]] const verify::StepLog& log() const { return passed; }
  [[nodiscard]] std::int64_t location(verify::InstanceId instance) const;
  [[nodiscard]] std::int64_t locationBefore(verify::InstanceId instance) const;

private:
  void setDates(verify::TransitionId step, Nanoseconds date);
  [[nodiscard]] Nanoseconds drawn(verify::TransitionId step);

  const Executable& executable;
  const verify::System& system;
  const verify::Enabling& enabling;
  Random random;
  verify::TransitionSet urgentOnes; ///< of the program's own steps
  verify::TransitionSet timedOnes;
  verify::TransitionSet enabled;
  verify::TransitionSet timedBefore; ///< those with a time that were enabled before the step
  std::vector<Nanoseconds> dates;    ///< when each enabled step with a time is due
  std::vector<verify::Word> now;
  std::vector<verify::Word> before;
  verify::StepLog passed;
};

} // namespace proskill::runtime
