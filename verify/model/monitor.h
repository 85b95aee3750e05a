#pragma once

#include "verify/model/dbm.h"
#include "verify/model/system.h"

#include <vector>

/// Automata that read a run of a model and accept those that violate a property: timed Büchi
/// automata with one clock. A run is read point by point: the state that it is in for a while, a
/// step, the next state. Alur and Dill, "A theory of timed automata", TCS 1994.
namespace proskill::verify {

/// What the clock has to be: `lower` limits 0 - x, `upper` limits x - 0.
struct ClockGuard {
  Bound lower = kZero;
  Bound upper = kInfinite;
};

struct MonitorEdge {
  bool ofStep = false; ///< taken with a step of the model; else at some moment in a state
  std::uint32_t to = 0;
  NodeId condition = 0; ///< of the step, or of the state
  ClockGuard clock;
  bool reset = false; ///< the clock starts anew
};

struct MonitorLocation {
  /// Holds of every state in which the monitor stays; in others it moves on at once or gives up.
  NodeId stay = 0;
  bool timed = false;     ///< the clock matters from here on
  bool accepting = false; ///< runs that come here again and again are violations
  bool error = false;     ///< runs that come here are violations, however they go on
  std::vector<MonitorEdge> edges;
};

struct Monitor {
  std::vector<MonitorLocation> locations;
  std::vector<std::uint32_t> initial;
  /// Whether steps may be left out that change no condition: not where positions count, as in LTL.
  bool ofPoints = true;
  /// Whether a state that is seen several times in a row is as good as one that is seen once.
  bool ofStates = true;
  bool fair = false; ///< only fair runs count: Question::fair

  [[nodiscard]] bool looksForCycles() const {
    for (const auto& location : locations)
      if (location.accepting) return true;
    return false;
  }
};

} // namespace proskill::verify
