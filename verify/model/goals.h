#pragma once

#include "verify/model/monitor.h"
#include "verify/model/nodes.h"
#include "verify/model/system.h"

#include <algorithm>
#include <string>
#include <vector>

namespace proskill::verify {

enum class GoalKind : std::uint8_t {
  Events,      ///< one of `events` happens
  Condition,   ///< `condition` holds of a state, or of a step from a state
  Deadlock,    ///< no transition is possible, and `condition` does not hold
  Stuck,       ///< time can never pass again
  Error,       ///< an evaluation fails at run time
  Run,         ///< a run that `monitor` accepts
  Lost,        ///< a moment from which `condition` cannot be seen any more
  Longest,     ///< the greatest value of the monitor's clock: see monitor/duration_monitor.h
  Shortest,    ///< the least one
  Unsupported, ///< the property cannot be checked, because of `reason`
};

/// What an exploration searches for to answer a question. If it is found, the property is false.
struct Goal {
  GoalKind kind = GoalKind::Unsupported;
  Bits events;
  NodeId condition = 0;
  bool ofSteps = false;   ///< the condition reads events of a step
  bool ofRuns = false;    ///< a monitor checks it, so every step that it reads counts
  bool initially = false; ///< Events: the initial state counts as one of the events
  std::string reason;
  Monitor monitor;
};

/// Whether a replayed run is enough to show that the property is false. What a system can never do,
/// or never takes longer to do, no single run shows.
[[nodiscard]] inline bool isShownByOneRun(const Goal& goal) {
  return goal.kind != GoalKind::Lost && goal.kind != GoalKind::Longest &&
         goal.kind != GoalKind::Shortest;
}

[[nodiscard]] inline bool askForErrors(const std::vector<Goal>& goals) {
  return std::ranges::any_of(goals, [](const Goal& goal) { return goal.kind == GoalKind::Error; });
}

/// The events that goals ask for.
[[nodiscard]] inline Bits eventsOf(const System& system, const std::vector<Goal>& goals) {
  Bits events;
  for (const auto& goal : goals) {
    events |= goal.events;
    addEvents(system, goal.condition, events);
  }
  return events;
}

/// Whether a question cannot share an exploration with others.
[[nodiscard]] inline bool hasOwnSearch(const Goal& goal) {
  return goal.kind == GoalKind::Run || !isShownByOneRun(goal);
}

} // namespace proskill::verify
