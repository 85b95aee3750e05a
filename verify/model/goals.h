#pragma once

#include "verify/model/monitor.h"
#include "verify/model/system.h"

#include <string>

namespace proskill::verify {

enum class GoalKind : std::uint8_t {
  Events,      ///< one of `events` happens
  Condition,   ///< `condition` holds of a state, or of a step from a state
  Deadlock,    ///< no transition is possible, and `condition` does not hold
  Stuck,       ///< time can never pass again
  Error,       ///< an evaluation fails at run time
  Run,         ///< a run that `monitor` accepts
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

} // namespace proskill::verify
