#pragma once

#include "verify/state/enabled.h"
#include "verify/state/timing.h"

#include <vector>

namespace proskill::verify {

/// The step of a run that started each clock, as the number of steps taken then; 0: at the start.
class ClockStarts {
public:
  explicit ClockStarts(const System& of)
      : system(&of), since(of.clocks.size()), ranAt(of.clocks.size()) {}

  [[nodiscard]] std::size_t of(ClockId clock) const { return since[clock]; }

  /// Records the clocks that this step starts: those that run after it and did not keep running.
  /// \param before transitions enabled before the step
  /// \param after transitions enabled after it
  /// \param taken number of steps taken, including this one
  void restart(TransitionId step, const TransitionSet& before, const TransitionSet& after,
               std::size_t taken) {
    const auto eachClock = [&](const TransitionSet& enabled, auto visit) {
      eachIn(enabled, [&](TransitionId id) {
        if (const auto clock = system->transitions[id].clock; clock != kNone) visit(clock);
      });
    };
    ++calls;
    eachClock(before, [&](ClockId clock) { ranAt[clock] = calls; });
    eachClock(after, [&](ClockId clock) {
      if (ranAt[clock] != calls || resets(*system, step, clock)) since[clock] = taken;
    });
  }

private:
  const System* system;
  std::vector<std::size_t> since; ///< by running clock
  /// By clock: the last call in which it was running before the step.
  std::vector<std::size_t> ranAt;
  std::size_t calls = 0;
};

} // namespace proskill::verify
