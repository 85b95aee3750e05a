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

Answer unknown(std::string reason) { return {Truth::Unknown, std::nullopt, std::move(reason)}; }

/// What evidence says, with its trace. Where a limit is met first there is none, but the verdict
/// stands.
Answer answerBy(const Goal& goal, const Evidence& evidence, const Witness& witness) {
  try {
    auto trace = witness.trace(goal, evidence);
    if (trace) return {Truth::False, std::move(*trace), {}};
    return unknown("internal error, please report it: " + trace.error());
  } catch (const LimitMet& limit) {
    return {Truth::False, std::nullopt, "without a trace: " + limit.which};
  }
}

/// The answer where nothing was found.
Answer answerWithoutEvidence(const Goal& goal, const Exploration& exploration,
                             const std::string& progressStopped) {
  if (goal.kind == GoalKind::Unsupported) return unknown(goal.reason);
  if (!exploration.complete) return unknown(exploration.stopped);
  if (goal.kind == GoalKind::Stuck && !progressStopped.empty()) return unknown(progressStopped);
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

/// Answers questions to a compiled model, each as soon as it is decided.
class Verification {
public:
  Verification(const Compiled& model, const fiacre::Provenance& origins, const Options& with,
               LimitWatch& watch, Result& to)
      : compiled(model),
        provenance(origins),
        options(with),
        limits(watch),
        result(to),
        whole(withStateLayout(model.system)) {
    result.exploration.complete = true;
  }

  /// \throw LimitMet where it is met before there is anything to explore
  std::optional<Unsupported> run() {
    const bool onlyRuns =
        !compiled.goals.empty() && std::ranges::all_of(compiled.goals, [](const Goal& goal) {
          return goal.kind == GoalKind::Run;
        });
    if (!onlyRuns)
      if (auto failure = explore()) return failure;
    for (std::size_t i = 0; i < compiled.goals.size(); ++i)
      if (compiled.goals[i].kind == GoalKind::Run)
        if (auto failure = watch(i)) return failure;
    return std::nullopt;
  }

private:
  /// Argued without priorities: steps that a reduction drops or puts off might go before others.
  [[nodiscard]] bool takes(Reduction reduction) const {
    const std::set<Reduction> withPriorities{Reduction::Inclusion, Reduction::Extrapolation};
    return options.reductions.contains(reduction) &&
           (!compiled.system.hasPriorities || withPriorities.contains(reduction));
  }

  /// Answers the questions about states and steps, by one exploration.
  std::optional<Unsupported> explore() {
    const auto& goals = compiled.goals;
    const Relevance relevance = takes(Reduction::DeadVariables)
                                    ? findRelevant(compiled.system, goals, limits)
                                    : everything(compiled.system);
    const System system = withStateLayout(compiled.system, relevance.cells);
    const StubbornSets stubbornSets(system, goals, relevance.dropped, limits);
    const LiveVariables liveVariables(system, goals, relevance.dropped, limits);
    const FreeInputs freeInputs(system, goals, relevance.dropped);
    const bool open = takes(Reduction::FreeInputs) && !freeInputs.none();
    const Reductions reductions{
        .inclusion = takes(Reduction::Inclusion),
        .stubbornSets = takes(Reduction::StubbornSets) ? &stubbornSets : nullptr,
        .liveVariables = takes(Reduction::LiveVariables) ? &liveVariables : nullptr,
        .freeInputs = open ? &freeInputs : nullptr,
        .dropped = relevance.dropped};
    const auto extrapolation =
        takes(Reduction::Extrapolation) ? Extrapolation::LowerUpper : Extrapolation::Least;
    const Witness witness(whole, reductions, provenance, limits);
    const auto found = search(system, goals, reductions, extrapolation, limits,
                              [&](std::size_t i, const Evidence& evidence) {
                                answer(i, answerBy(goals[i], evidence, witness));
                              });
    if (found.failure) return found.failure;
    result.exploration = found.statistics;
    for (std::size_t i = 0; i < goals.size(); ++i)
      if (goals[i].kind != GoalKind::Run && !found.goals[i])
        answer(i, answerWithoutEvidence(goals[i], found.statistics, found.progressStopped));
    return std::nullopt;
  }

  /// Answers a question about runs, by an exploration of its own.
  std::optional<Unsupported> watch(std::size_t index) {
    const Goal& goal = compiled.goals[index];
    const auto seen = watchedBy(goal.monitor);
    const bool slices = takes(Reduction::DeadVariables) && goal.monitor.ofPoints;
    const Relevance relevance =
        slices ? findRelevant(compiled.system, seen, limits) : everything(compiled.system);
    const System system = withStateLayout(compiled.system, relevance.cells);
    const LiveVariables live(system, seen, relevance.dropped, limits);
    auto found = watchFor(system, goal.monitor, takes(Reduction::LiveVariables) ? &live : nullptr,
                          relevance.dropped, errorsAreAsked(), limits);
    if (!found.failure.empty()) return Unsupported{found.failure, found.failureOrigin};
    if (found.evidence) found.statistics.complete = true;
    add(result.exploration, found.statistics);
    const Reductions used{.dropped = relevance.dropped};
    const Witness witness(whole, used, provenance, limits);
    answer(index, found.evidence ? answerBy(goal, *found.evidence, witness)
                                 : answerWithoutEvidence(goal, found.statistics, {}));
    return std::nullopt;
  }

  [[nodiscard]] bool errorsAreAsked() const {
    return std::ranges::any_of(compiled.goals,
                               [](const Goal& goal) { return goal.kind == GoalKind::Error; });
  }

  void answer(std::size_t index, Answer made) {
    result.answers[index] = {made.truth, std::nullopt, made.reason};
    if (options.decided && made.truth != Truth::Unknown)
      options.decided(index, std::move(made));
    else
      result.answers[index].trace = std::move(made.trace);
  }

  const Compiled& compiled;
  const fiacre::Provenance& provenance;
  const Options& options;
  LimitWatch& limits;
  Result& result;
  System whole; ///< with every cell kept
};

/// Leaves open what is not decided when a limit is met.
void giveUp(const LimitMet& limit, Result& result) {
  result.exploration.complete = false;
  result.exploration.stopped = limit.which;
  for (auto& answer : result.answers)
    if (answer.truth == Truth::Unknown && answer.reason.empty()) answer = unknown(limit.which);
}

} // namespace

std::expected<Result, Unsupported> verify(const fiacre::Program& program,
                                          const fiacre::Provenance& provenance,
                                          const std::vector<Question>& questions,
                                          const Options& options) {
  LimitWatch limits(options);
  Result result;
  result.answers.resize(questions.size());
  try {
    const auto compiled = compile(program, provenance, questions, &limits);
    if (!compiled) return std::unexpected(compiled.error());
    Verification verification(*compiled, provenance, options, limits, result);
    if (auto failure = verification.run()) return std::unexpected(*failure);
  } catch (const LimitMet& limit) {
    giveUp(limit, result);
  }
  result.exploration.seconds = limits.seconds();
  return result;
}

} // namespace proskill::verify
