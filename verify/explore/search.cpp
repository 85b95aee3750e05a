#include "verify/explore/search.h"

#include "verify/progress/graph_nodes.h"
#include "verify/reduce/free_inputs.h"
#include "verify/state/exact_zone.h"

#include <algorithm>

namespace proskill::verify {

namespace {

bool isStuckGoal(const Goal& goal) { return goal.kind == GoalKind::Stuck; }

/// \throw LimitMet
std::optional<Evidence> findStuck(const System& system, const Reductions& reductions,
                                  Explorer& explorer, LimitWatch& limits) {
  GraphNodes nodes(explorer.explored());
  ProgressCheck check(system, reductions, nodes, limits);
  auto stuck = check.find();
  if (!check.stopped().empty()) throw LimitMet{check.stopped()};
  if (!stuck) return std::nullopt;
  const ZoneGraph& graph = explorer.explored();
  const auto node = static_cast<NodeIndex>(stuck->node);
  Evidence evidence{explorer.pathTo(node), stuck->clocks};
  if (!reductions.freeInputs) return evidence;
  std::vector<Word> stored(system.words);
  graph.states.read(graph.stateOf(node), stored.data());
  const auto inputs = reductions.freeInputs->between(stored.data(), stuck->state.data());
  evidence.steps.insert(evidence.steps.end(), inputs.begin(), inputs.end());
  return evidence;
}

/// Repeats the search with finer zones, in a separate exploration.
/// \throw LimitMet
std::optional<Evidence> findStuckFiner(const System& system, const std::vector<Goal>& goals,
                                       const Reductions& reductions, LimitWatch& limits,
                                       SearchResult& result) {
  std::vector<Goal> stuckGoals;
  std::ranges::copy_if(goals, std::back_inserter(stuckGoals), isStuckGoal);
  Explorer finer(system, stuckGoals, reductions, Extrapolation::Maximum, limits);
  Explored again = finer.run();
  const bool complete = result.statistics.complete;
  add(result.statistics, again.statistics);
  if (complete && !again.statistics.complete) { // the other questions are decided
    result.statistics.complete = true;
    result.statistics.stopped.clear();
  }
  auto stuck = findStuck(system, reductions, finer, limits);
  if (!stuck && !again.statistics.complete) throw LimitMet{again.statistics.stopped};
  return stuck;
}

/// Whether time can stop. If undecided, the result says which limit was reached.
std::optional<Evidence> findStuck(const System& system, const std::vector<Goal>& goals,
                                  const Reductions& reductions, Extrapolation extrapolation,
                                  Explorer& explorer, LimitWatch& limits, SearchResult& result) {
  try {
    auto stuck = findStuck(system, reductions, explorer, limits);
    // Extra+LU may put clocks nearer to their upper bounds than they get; maximum bounds do not
    if (stuck && extrapolation == Extrapolation::LowerUpper && !isReal(system, *stuck, limits))
      return findStuckFiner(system, goals, reductions, limits, result);
    return stuck;
  } catch (const LimitMet& limit) {
    result.progressStopped = limit.which;
    return std::nullopt;
  }
}

} // namespace

bool isReal(const System& system, const Evidence& evidence, LimitWatch& limits) {
  auto reached = exactZone(system, evidence.steps, limits.asCheck());
  if (!reached) return false;
  auto& [clocks, last] = *reached;
  return std::ranges::all_of(evidence.clocks, [&](const ClockRange& range) {
    auto at =
        static_cast<std::uint32_t>(std::ranges::lower_bound(clocks, range.clock) - clocks.begin()) +
        1;
    return last.constrain(0, at, range.lower) && last.constrain(at, 0, range.upper);
  });
}

void addCounts(Exploration& to, const Exploration& more) {
  to.classes += more.classes;
  to.markings += more.markings;
  to.domains += more.domains;
  to.transitions += more.transitions;
  to.bytes = std::max(to.bytes, more.bytes);
  to.ranks = std::max(to.ranks, more.ranks);
  to.messages += more.messages;
  to.sentBytes += more.sentBytes;
  to.spilledBytes = std::max(to.spilledBytes, more.spilledBytes);
}

void add(Exploration& to, const Exploration& more) {
  addCounts(to, more);
  to.seconds = more.seconds;
  to.complete = to.complete && more.complete;
  if (to.stopped.empty()) to.stopped = more.stopped;
}

SearchResult search(const System& system, const std::vector<Goal>& goals,
                    const Reductions& reductions, Extrapolation extrapolation, LimitWatch& limits,
                    const OnEvidence& onFound, const Pause& pause, Guide guide,
                    Checkpoint* checkpoint) {
  SearchResult result;
  result.goals.resize(goals.size());
  const auto note = [&](std::size_t goal, const Evidence& evidence) {
    result.goals[goal] = evidence;
    onFound(goal, evidence);
  };
  Explorer explorer(
      system, goals, reductions, extrapolation, limits,
      [&](std::size_t goal, const Steps& steps) {
        note(goal, Evidence{steps, {}});
      },
      pause, guide, checkpoint);
  Explored explored = explorer.run();
  result.statistics = explored.statistics;
  if (!explored.failure.empty())
    result.failure = Unsupported{explored.failure, explored.failureOrigin};
  result.paused = explored.paused;
  result.limited = explored.limited;
  if (result.failure || result.paused || std::ranges::none_of(goals, isStuckGoal)) return result;

  if (!result.limited) explorer.saveIfDue(); // what follows may take long, too
  const auto stuck = findStuck(system, goals, reductions, extrapolation, explorer, limits, result);
  if (!result.progressStopped.empty() && !result.limited) {
    result.limited = true;
    explorer.save();
  }
  result.statistics.seconds = limits.seconds();
  for (std::size_t i = 0; stuck && i < goals.size(); ++i)
    if (isStuckGoal(goals[i])) note(i, *stuck);
  return result;
}

} // namespace proskill::verify
