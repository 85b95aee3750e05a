#pragma once

#include "verify/state/enabled.h"
#include "verify/state/timing.h"

#include <vector>

namespace proskill::verify {

/// Which step of a run started each clock: how many had been taken then, 0 at the start.
class ClockStarts {
public:
  explicit ClockStarts(const System& of) : system(of), since(of.clocks.size()) {}

  [[nodiscard]] std::size_t of(ClockId clock) const { return since[clock]; }

  /// Clocks that do not go on start at the step.
  /// \param before the transitions that were enabled before it
  void restart(TransitionId step, const TransitionSet& before, std::size_t taken) {
    std::vector<bool> ran(since.size());
    eachIn(before, [&](TransitionId id) {
      if (system.transitions[id].clock != kNone) ran[system.transitions[id].clock] = true;
    });
    for (ClockId clock = 0; clock < since.size(); ++clock)
      if (!ran[clock] || resets(system, step, clock)) since[clock] = taken;
  }

private:
  const System& system;
  std::vector<std::size_t> since; ///< by clock
};

} // namespace proskill::verify
