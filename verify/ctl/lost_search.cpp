#include "verify/ctl/lost_search.h"

#include "verify/ctl/lost_states.h"
#include "verify/explore/conclude.h"

namespace proskill::verify {

std::vector<Goal> preservedFor(const Goal& goal) {
  return {
      {.kind = GoalKind::Condition, .condition = goal.condition, .ofSteps = true, .ofRuns = true}};
}

LostSearch searchLost(const Prepared& prepared, const Goal& goal, bool errorsAreAsked,
                      LimitWatch& limits) {
  LostSearch result;
  std::vector<Goal> goals{{.kind = GoalKind::Stuck}}; // is never found, so everything is explored
  if (errorsAreAsked) goals.push_back({.kind = GoalKind::Error});
  const bool isAbstract = prepared.extrapolation == Extrapolation::LowerUpper;
  Explorer explorer(prepared.system, goals, prepared.reductions,
                    isAbstract ? Extrapolation::Maximum : prepared.extrapolation, limits);
  Explored explored = explorer.run();
  result.statistics = explored.statistics;
  result.failure = std::move(explored.failure);
  result.failureOrigin = explored.failureOrigin;
  if (!result.statistics.complete) return result;
  exploreWithinLimits(result.statistics, [&] {
    LostStates states(prepared.system, prepared.reductions, goal.condition, explorer, limits);
    result.evidence = states.find();
  });
  result.statistics.complete = result.statistics.stopped.empty();
  result.statistics.seconds = limits.seconds();
  return result;
}

} // namespace proskill::verify
