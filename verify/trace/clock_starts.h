#pragma once

#include "verify/state/enabled.h"
#include "verify/state/timing.h"

#include <vector>

namespace proskill::verify {

/// Which step of a run started each clock: how many had been taken then, 0 at the start.
class ClockStarts {
public:
  explicit ClockStarts(const System& of)
      : system(of), since(of.clocks.size()), ranAt(of.clocks.size()) {}

  [[nodiscard]] std::size_t of(ClockId clock) const { return since[clock]; }

  /// Clocks that run after the step and do not go on start at it.
  /// \param before the transitions that were enabled before it
  /// \param after those that are enabled now
  /// \param taken how many steps were taken with this one
  void restart(TransitionId step, const TransitionSet& before, const TransitionSet& after,
               std::size_t taken) {
    const auto eachClock = [&](const TransitionSet& enabled, auto visit) {
      eachIn(enabled, [&](TransitionId id) {
        if (const auto clock = system.transitions[id].clock; clock != kNone) visit(clock);
      });
    };
    ++calls;
    eachClock(before, [&](ClockId clock) { ranAt[clock] = calls; });
    eachClock(after, [&](ClockId clock) {
      if (ranAt[clock] != calls || resets(system, step, clock)) since[clock] = taken;
    });
  }

private:
  const System& system;
  std::vector<std::size_t> since; ///< by clock that runs
  std::vector<std::size_t> ranAt; ///< by clock: the last call that found it running before
  std::size_t calls = 0;
};

} // namespace proskill::verify
