#pragma once

#include "runtime/clock/clock.h"
#include "runtime/control/wake_up.h"

#include <chrono>
#include <mutex>

namespace proskill::runtime {

/// Pauses a run, and lets it take single steps. Any thread may call what is not marked as the
/// run's. While a run is not paused, it takes no lock here.
class Pause {
public:
  void hold();
  void resume();
  /// Lets a paused run take its next step.
  void step();
  [[nodiscard]] bool isHeld() const { return held.load(std::memory_order_relaxed); }
  /// The time of the run, from the last report of its clock.
  /// \param speed seconds of the run per second
  [[nodiscard]] Nanoseconds date(double speed) const;

  /// The run's: whether it may take a step now.
  [[nodiscard]] bool admits() const {
    return !isHeld() || permits.load(std::memory_order_relaxed) > 0;
  }
  /// The run's: it takes a step.
  void passed();
  /// The clock's: its date, and whether it goes on from there.
  void tell(Nanoseconds date, bool runs);

  WakeUp wakeUp; ///< wakes the run, which acknowledges it after each wait

private:
  std::atomic<bool> held{false};
  std::atomic<int> permits{0};
  mutable std::mutex mutex; ///< guards what follows
  Nanoseconds told = 0;
  bool isRunning = false;
  std::chrono::steady_clock::time_point toldAt;
};

/// A clock that stands still while the run is paused. A single step takes it to the date of that
/// step at once; later it goes on from there.
/// \pre the pause outlives it; its run has no descriptors that are readable while it is paused
[[nodiscard]] std::unique_ptr<Clock> pausableClock(std::unique_ptr<Clock> inner, Pause& pause);

} // namespace proskill::runtime
