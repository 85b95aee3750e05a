#include "verify/verify.h"

#include "verify/compile/compile.h"
#include "verify/explore/monitor_search.h"
#include "verify/explore/search.h"
#include "verify/reduce/dead_variables.h"
#include "verify/reduce/free_inputs.h"
#include "verify/reduce/live_variables.h"
#include "verify/reduce/monitor_view.h"
#include "verify/reduce/private_moves.h"
#include "verify/reduce/stubborn_sets.h"
#include "verify/state/state_layout.h"
#include "verify/trace/witness.h"

#include <algorithm>
#include <utility>

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

/// Whether a reduction keeps all that a monitor sees.
bool suits(const Monitor& monitor, Reduction reduction, const System& system) {
  switch (reduction) {
  case Reduction::DeadVariables: return monitor.ofPoints || watchesStates(monitor, system);
  case Reduction::FreeInputs: return watchesPoints(monitor) || watchesStates(monitor, system);
  case Reduction::StubbornSets: return watchesPoints(monitor);
  case Reduction::PrivateMoves: return false;
  case Reduction::LiveVariables:
  case Reduction::Inclusion:
  case Reduction::Extrapolation: return true;
  }
  std::unreachable();
}

/// A system as a search for some goals looks at it.
struct Prepared {
  /// \throw LimitMet
  Prepared(const System& whole, const std::vector<Goal>& goals,
           const std::function<bool(Reduction)>& takes, LimitWatch& limits)
      : relevance(takes(Reduction::DeadVariables) ? findRelevant(whole, goals, limits)
                                                  : everything(whole)),
        system(withStateLayout(whole, relevance.cells)) {
    const Bits& dropped = reductions.dropped = relevance.dropped;
    reductions.inclusion = takes(Reduction::Inclusion);
    if (takes(Reduction::StubbornSets))
      reductions.stubbornSets = &stubbornSets.emplace(system, goals, dropped, limits);
    if (takes(Reduction::LiveVariables))
      reductions.liveVariables = &liveVariables.emplace(system, goals, dropped, limits);
    if (takes(Reduction::FreeInputs) && !freeInputs.emplace(system, goals, dropped).none())
      reductions.freeInputs = &*freeInputs;
    if (takes(Reduction::PrivateMoves) && reductions.freeInputs &&
        !privateMoves.emplace(system, goals, dropped, *freeInputs).none())
      reductions.privateMoves = &*privateMoves;
  }
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  Relevance relevance;
  System system;
  std::optional<StubbornSets> stubbornSets;
  std::optional<LiveVariables> liveVariables;
  std::optional<FreeInputs> freeInputs;
  std::optional<PrivateMoves> privateMoves;
  Reductions reductions;
};

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
    const Prepared prepared(
        compiled.system, goals, [&](Reduction r) { return takes(r); }, limits);
    const auto extrapolation =
        takes(Reduction::Extrapolation) ? Extrapolation::LowerUpper : Extrapolation::Least;
    const Witness witness(whole, prepared.reductions, provenance, limits);
    const auto found = search(prepared.system, goals, prepared.reductions, extrapolation, limits,
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
    const auto seen = goalsOf(goal.monitor);
    const Prepared prepared(
        compiled.system, seen,
        [&](Reduction r) { return takes(r) && suits(goal.monitor, r, compiled.system); }, limits);
    auto found = watchFor(prepared.system, goal.monitor, prepared.reductions, options.obliged,
                          errorsAreAsked(), limits);
    if (!found.failure.empty()) return Unsupported{found.failure, found.failureOrigin};
    if (found.evidence) found.statistics.complete = true;
    add(result.exploration, found.statistics);
    const Witness witness(whole, prepared.reductions, provenance, limits);
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
