#include "verify/reduce/monitor_view.h"

#include "verify/model/nodes.h"
#include "verify/reduce/path_facts.h"

#include <algorithm>

namespace proskill::verify {

bool watchesPoints(const Monitor& monitor) { return monitor.ofPoints && !monitor.looksForCycles(); }

bool watchesStates(const Monitor& monitor, const System& system) {
  if (!monitor.fair || !monitor.ofStates) return false;
  return monitor.ofPoints || std::ranges::none_of(goalsOf(monitor), [&](const Goal& goal) {
           return watchesSteps(system, goal.condition);
         });
}

bool suits(const Monitor& monitor, Reduction reduction, const System& system) {
  switch (reduction) {
  case Reduction::DeadVariables: return monitor.ofPoints || watchesStates(monitor, system);
  case Reduction::FreeInputs: return watchesPoints(monitor) || watchesStates(monitor, system);
  case Reduction::StubbornSets: return watchesPoints(monitor);
  case Reduction::PrivateMoves:
  case Reduction::Slices:
  case Reduction::Refinement: return false;
  case Reduction::LiveVariables:
  case Reduction::Inclusion:
  case Reduction::Extrapolation: return true;
  }
  std::unreachable();
}

std::vector<Goal> goalsOf(const Monitor& monitor) {
  std::vector<Goal> all;
  const auto add = [&](NodeId condition) {
    all.push_back(
        {.kind = GoalKind::Condition, .condition = condition, .ofSteps = true, .ofRuns = true});
  };
  for (const auto& location : monitor.locations) {
    add(location.stay);
    for (const auto& edge : location.edges) add(edge.condition);
  }
  // A process that is skipped must have no endless cycle, which would be an infinite run of its
  // own.
  if (monitor.looksForCycles()) all.push_back({.kind = GoalKind::Deadlock});
  return all;
}

Bits stepsSeenBy(const Monitor& monitor, const System& system) {
  Bits cells;
  Bits events;
  for (const auto& goal : goalsOf(monitor)) {
    addReads(system, goal.condition, cells);
    addEvents(system, goal.condition, events);
  }
  Bits seen;
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    const auto& transition = system.transitions[i];
    if (!watchesPoints(monitor) || transition.writes.meets(cells) ||
        mayPass(system, transition, events))
      seen.insert(i);
  }
  return seen;
}

} // namespace proskill::verify
