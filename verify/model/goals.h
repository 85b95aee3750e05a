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
  Error,       ///< something fails at run time
  Run,         ///< a run that `monitor` accepts
  Unsupported, ///< for `reason`
};

/// What an exploration looks for to answer a question. Found: the property is false.
struct Goal {
  GoalKind kind = GoalKind::Unsupported;
  Bits events;
  NodeId condition = 0;
  bool ofSteps = false;   ///< the condition watches what happens in a step
  bool ofRuns = false;    ///< a monitor watches it: each step that it sees counts
  bool initially = false; ///< Events: the initial state is one of those asked for
  std::string reason;
  Monitor monitor;
};

} // namespace proskill::verify
