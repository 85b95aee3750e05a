#pragma once

#include "verify/model/dbm.h"
#include "verify/model/system.h"

#include <set>
#include <string>
#include <vector>

/// Automata that read a run of a model and accept the runs that violate a property: timed Büchi
/// automata with one clock. A monitor reads a run point by point: a state during its stay, a step,
/// the next state. Alur and Dill, "A theory of timed automata", TCS 1994.
namespace proskill::verify {

/// A constraint on the clock x: `lower` limits 0 - x, `upper` limits x - 0.
struct ClockGuard {
  Bound lower = kZero;
  Bound upper = kInfinite;
};

struct MonitorEdge {
  /// Taken together with a step of the model; otherwise during a stay in a state.
  bool ofStep = false;
  std::uint32_t to = 0;
  NodeId condition = 0; ///< of the step, or of the state
  ClockGuard clock;
  bool reset = false; ///< the clock is reset
};

struct MonitorLocation {
  /// Condition on every state in which the monitor stays; in other states it moves on at once, or
  /// the attempt ends.
  NodeId stay = 0;
  bool timed = false;     ///< the clock is used from here on
  bool accepting = false; ///< runs that visit this location infinitely often are violations
  bool error = false;     ///< runs that reach this location are violations, whatever follows
  std::vector<MonitorEdge> edges;
};

/// Locations of the monitors of durations (monitor/duration_monitor.h): during a measurement, and
/// after it.
inline constexpr std::uint32_t kMeasuring = 2;
inline constexpr std::uint32_t kMeasured = 3;

struct Monitor {
  std::vector<MonitorLocation> locations;
  std::vector<std::uint32_t> initial;
  /// Whether steps may be skipped that change no condition. False where positions count, as in LTL.
  bool ofPoints = true;
  /// Whether a state may be read several times in a row with the same result as once.
  bool ofStates = true;
  bool fair = false;            ///< only fair runs count: Question::fair
  std::set<std::string> exempt; ///< Question::exempt
  bool rests = false;           ///< Question::rests

  /// Whether a run may end where no step is forced.
  [[nodiscard]] bool letsRest() const { return fair || rests; }
  [[nodiscard]] bool looksForCycles() const {
    for (const auto& location : locations)
      if (location.accepting) return true;
    return false;
  }
};

} // namespace proskill::verify
