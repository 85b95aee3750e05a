#include "verify/explore/search.h"

#include "verify/reduce/free_inputs.h"
#include "verify/state/state_layout.h"

#include <algorithm>

namespace proskill::verify {

namespace {

bool isStuckGoal(const Goal& goal) { return goal.kind == GoalKind::Stuck; }

/// Whether a run along these steps ends with the clocks in these ranges: computes the zones along
/// it, extrapolated only as far as that is exact.
bool isReal(const System& system, const Evidence& evidence) {
  Timing timing(system, Extrapolation::Least);
  Enabling enabling(system);
  StepLog log;
  std::vector<Word> state = initialState(system);
  TransitionSet enabled;
  enabling.compute(state.data(), enabled);
  SignatureId signature = enabling.signature(enabled, timing);
  ZoneId zone = timing.initial(signature);
  for (auto step : evidence.steps) {
    if (fire(system, step, state.data(), log) != Outcome::Done) return false;
    enabling.update(step, state.data(), enabled);
    const SignatureId next = enabling.signature(enabled, timing);
    zone = timing.after(zone, signature, step, next);
    if (zone == kNone) return false;
    signature = next;
  }
  Dbm last = timing.zones().zone(zone);
  const auto& clocks = timing.at(signature).clocks;
  return std::ranges::all_of(evidence.clocks, [&](const ClockRange& range) {
    auto at =
        static_cast<std::uint32_t>(std::ranges::lower_bound(clocks, range.clock) - clocks.begin()) +
        1;
    return last.constrain(0, at, range.lower) && last.constrain(at, 0, range.upper);
  });
}

/// \throw LimitMet
std::optional<Evidence> findStuck(const System& system, const Reductions& reductions,
                                  Explorer& explorer, LimitWatch& limits) {
  ProgressCheck check(system, reductions, explorer.explored(), limits);
  auto stuck = check.find();
  if (!check.stopped().empty()) throw LimitMet{check.stopped()};
  if (!stuck) return std::nullopt;
  const ZoneGraph& graph = explorer.explored();
  Evidence evidence{explorer.pathTo(stuck->node), stuck->clocks};
  if (!reductions.freeInputs) return evidence;
  std::vector<Word> stored(system.words);
  std::copy_n(graph.states.at(graph.nodes[stuck->node].state), system.storedWords, stored.begin());
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
    if (stuck && extrapolation == Extrapolation::LowerUpper && !isReal(system, *stuck))
      return findStuckFiner(system, goals, reductions, limits, result);
    return stuck;
  } catch (const LimitMet& limit) {
    result.progressStopped = limit.which;
    return std::nullopt;
  }
}

} // namespace

void addCounts(Exploration& to, const Exploration& more) {
  to.classes += more.classes;
  to.markings += more.markings;
  to.domains += more.domains;
  to.transitions += more.transitions;
  to.bytes = std::max(to.bytes, more.bytes);
}

void add(Exploration& to, const Exploration& more) {
  addCounts(to, more);
  to.seconds = more.seconds;
  to.complete = to.complete && more.complete;
  if (to.stopped.empty()) to.stopped = more.stopped;
}

SearchResult search(const System& system, const std::vector<Goal>& goals,
                    const Reductions& reductions, Extrapolation extrapolation, LimitWatch& limits,
                    const OnEvidence& onFound, const Pause& pause, GoalDistance* distance) {
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
      pause, distance);
  Explored explored = explorer.run();
  result.statistics = explored.statistics;
  if (!explored.failure.empty())
    result.failure = Unsupported{explored.failure, explored.failureOrigin};
  result.paused = explored.paused;
  if (result.failure || result.paused || std::ranges::none_of(goals, isStuckGoal)) return result;

  const auto stuck = findStuck(system, goals, reductions, extrapolation, explorer, limits, result);
  result.statistics.seconds = limits.seconds();
  for (std::size_t i = 0; stuck && i < goals.size(); ++i)
    if (isStuckGoal(goals[i])) note(i, *stuck);
  return result;
}

} // namespace proskill::verify
