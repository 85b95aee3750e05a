#include "verify/verify.h"

#include "verify/compile/compile.h"
#include "verify/explore/monitor_search.h"
#include "verify/explore/search.h"
#include "verify/reduce/dead_variables.h"
#include "verify/reduce/free_inputs.h"
#include "verify/reduce/live_variables.h"
#include "verify/reduce/stubborn_sets.h"
#include "verify/state/state_layout.h"
#include "verify/trace/witness.h"

#include <algorithm>

namespace proskill::verify {

namespace {

Answer answerOf(const Goal& goal, const std::optional<Evidence>& evidence,
                const SearchResult& found, const Witness& witness) {
  const Exploration& exploration = found.statistics;
  if (goal.kind == GoalKind::Unsupported) return {Truth::Unknown, std::nullopt, goal.reason};
  if (evidence) {
    auto trace = witness.trace(goal, *evidence);
    if (trace) return {Truth::False, std::move(*trace), {}};
    return {Truth::Unknown, std::nullopt, "internal error, please report it: " + trace.error()};
  }
  if (!exploration.complete) return {Truth::Unknown, std::nullopt, exploration.stopped};
  if (goal.kind == GoalKind::Stuck && !found.progressStopped.empty())
    return {Truth::Unknown, std::nullopt, found.progressStopped};
  return {Truth::True, std::nullopt, {}};
}

/// What a monitor looks at, as goals are known to the reductions.
std::vector<Goal> watchedBy(const Monitor& monitor) {
  std::vector<Goal> all;
  const auto add = [&](NodeId condition) {
    all.push_back({.kind = GoalKind::Condition, .condition = condition, .ofSteps = true});
  };
  for (const auto& location : monitor.locations) {
    add(location.stay);
    for (const auto& edge : location.edges) add(edge.condition);
  }
  // A process that is left out must not go round and round: that would be a run of its own.
  if (monitor.looksForCycles()) all.push_back({.kind = GoalKind::Deadlock});
  return all;
}

struct Watching {
  Answer answer;
  Exploration statistics;
  std::optional<Unsupported> failure;
};

/// Answers a question about runs, by an exploration of its own.
Watching watch(const System& compiled, const System& whole, const Goal& goal,
               const fiacre::Provenance& provenance, const Options& options, bool errorsAreAsked,
               LimitWatch& limits) {
  const auto seen = watchedBy(goal.monitor);
  const auto takes = [&](Reduction reduction) {
    return options.reductions.contains(reduction) && !compiled.hasPriorities;
  };
  const bool slices = takes(Reduction::DeadVariables) && goal.monitor.ofPoints;
  const Relevance relevance = slices ? findRelevant(compiled, seen) : everything(compiled);
  const System system = withStateLayout(compiled, relevance.cells);
  const LiveVariables live(system, seen, relevance.dropped);
  auto found = watchFor(system, goal.monitor, takes(Reduction::LiveVariables) ? &live : nullptr,
                        relevance.dropped, errorsAreAsked, limits);
  if (!found.failure.empty())
    return {{}, found.statistics, Unsupported{found.failure, found.failureOrigin}};
  if (found.evidence) found.statistics.complete = true;
  const Reductions used{.dropped = relevance.dropped};
  const Witness witness(whole, used, provenance);
  return {answerOf(goal, found.evidence, {.statistics = found.statistics}, witness),
          found.statistics,
          {}};
}

} // namespace

std::expected<Result, Unsupported> verify(const fiacre::Program& program,
                                          const fiacre::Provenance& provenance,
                                          const std::vector<Question>& questions,
                                          const Options& options) {
  LimitWatch limits(options);
  auto compiled = compile(program, provenance, questions);
  if (!compiled) return std::unexpected(compiled.error());
  // Argued without priorities: steps that one drops or puts off might go before others.
  const std::set<Reduction> withPriorities{Reduction::Inclusion, Reduction::Extrapolation};
  const auto takes = [&](Reduction reduction) {
    return options.reductions.contains(reduction) &&
           (!compiled->system.hasPriorities || withPriorities.contains(reduction));
  };
  const Relevance relevance = takes(Reduction::DeadVariables)
                                  ? findRelevant(compiled->system, compiled->goals)
                                  : everything(compiled->system);
  const System system = withStateLayout(compiled->system, relevance.cells);
  const StubbornSets stubbornSets(system, compiled->goals, relevance.dropped);
  const LiveVariables liveVariables(system, compiled->goals, relevance.dropped);
  const FreeInputs freeInputs(system, compiled->goals, relevance.dropped);
  const bool open = takes(Reduction::FreeInputs) && !freeInputs.none();
  const Reductions reductions{
      .inclusion = takes(Reduction::Inclusion),
      .stubbornSets = takes(Reduction::StubbornSets) ? &stubbornSets : nullptr,
      .liveVariables = takes(Reduction::LiveVariables) ? &liveVariables : nullptr,
      .freeInputs = open ? &freeInputs : nullptr,
      .dropped = relevance.dropped};
  const auto extrapolation =
      takes(Reduction::Extrapolation) ? Extrapolation::LowerUpper : Extrapolation::Least;
  const bool errorsAreAsked = std::ranges::any_of(
      compiled->goals, [](const Goal& goal) { return goal.kind == GoalKind::Error; });
  const bool onlyRuns =
      !compiled->goals.empty() && std::ranges::all_of(compiled->goals, [](const Goal& goal) {
        return goal.kind == GoalKind::Run;
      });
  SearchResult found{.statistics = {.complete = true}};
  if (!onlyRuns) found = search(system, compiled->goals, reductions, extrapolation, limits);
  if (found.failure) return std::unexpected(*found.failure);
  const System whole = withStateLayout(compiled->system);
  const Witness witness(whole, reductions, provenance);
  Result result;
  result.exploration = found.statistics;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const Goal& goal = compiled->goals[i];
    if (goal.kind != GoalKind::Run) {
      result.answers.push_back(answerOf(goal, found.goals[i], found, witness));
      continue;
    }
    auto watched =
        watch(compiled->system, whole, goal, provenance, options, errorsAreAsked, limits);
    if (watched.failure) return std::unexpected(*watched.failure);
    result.answers.push_back(std::move(watched.answer));
    add(result.exploration, watched.statistics);
  }
  return result;
}

} // namespace proskill::verify
