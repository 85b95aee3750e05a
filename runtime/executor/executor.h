#pragma once

#include "runtime/clock/clock.h"
#include "runtime/executor/observer.h"

#include <atomic>

namespace proskill::runtime {

enum class End : std::uint8_t {
  Mission,   ///< the mission has ended, and no action runs
  Until,     ///< the time was over
  Stopped,   ///< somebody asked for it
  Abandoned, ///< somebody asked twice, or actions did not stop in time
  Stuck,     ///< nothing can happen any more
  NoTime,    ///< steps without end at one date
  Failed,    ///< a step is an error of the model
  Lost,      ///< the platform has ended, and an action should have started
};

struct RunOptions {
  std::uint64_t seed = 0;
  std::optional<Nanoseconds> until;
  /// How long actions may take to stop before the platform is given up.
  Nanoseconds grace = 5 * kSecond;
  /// So many steps at one date are taken for steps without end.
  std::uint64_t mostAtOnce = 1'000'000;
  /// How often somebody has asked for the end. May be null.
  const std::atomic<int>* stopRequests = nullptr;
  int stopDescriptor = -1; ///< an eventfd that is written to when that changes
};

struct RunResult {
  End end = End::Mission;
  Nanoseconds date = 0;
  std::uint64_t steps = 0;
  std::uint64_t bad = 0; ///< remarks on what should not be
  Nanoseconds maxLag = 0;
  std::string missionStatus; ///< `success`; empty where there is no mission
  std::string failure;       ///< Failed
};

/// Executes a program: what is urgent at once, what has a time at that time, what comes from
/// outside when the platform reports it. A step's date is when the model takes it: that of a step
/// with a time is its own, even where this process woke up later. \pre the arguments outlive the
/// call
[[nodiscard]] RunResult execute(const Executable& executable, Clock& clock, Platform& platform,
                                Observer& observer, const RunOptions& options);

} // namespace proskill::runtime
