#pragma once

#include "runtime/control/pause.h"
#include "runtime/monitor/property_monitors.h"

#include <atomic>

namespace proskill::runtime {

enum class End : std::uint8_t {
  Mission,   ///< the mission has ended, and no action runs
  Until,     ///< the time limit was reached
  Stopped,   ///< the run was asked to end
  Abandoned, ///< the run was asked to end twice, or actions did not stop in time
  Stuck,     ///< no step is possible any more
  NoTime,    ///< endless steps at one date
  Failed,    ///< a step fails, which is an error of the model
  Lost,      ///< the platform has ended, and an action should have started
};

struct RunOptions {
  std::uint64_t seed = 0;
  std::optional<Nanoseconds> until;
  /// Time that an action has to stop before it is given up.
  Nanoseconds grace = 5 * kSecond;
  /// Likewise for all of them when the run ends, and then for the platform; nullopt: as `grace`.
  std::optional<Nanoseconds> endGrace;
  /// Number of steps at one date that is taken for an endless loop.
  std::uint64_t mostAtOnce = 100'000;
  /// Counts requests to end the run. May be null.
  const std::atomic<int>* stopRequests = nullptr;
  int stopDescriptor = -1; ///< an eventfd that is written to at each request
  /// May be null. Otherwise the clock is `pausableClock` of it.
  Pause* pause = nullptr;
};

struct RunResult {
  End end = End::Mission;
  Nanoseconds date = 0;
  std::uint64_t steps = 0;
  std::uint64_t bad = 0; ///< remarks that report a fault
  Nanoseconds maxLag = 0;
  std::string missionStatus; ///< such as `success`; empty if there is no mission
  std::string failure;       ///< Failed: the reason
  /// Verdicts on the program's own properties, by Executable::properties.
  std::vector<PropertyMonitors::Decision> verdicts;
};

} // namespace proskill::runtime
