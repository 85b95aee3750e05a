#include "verify/verify.h"

#include "verify/compile.h"
#include "verify/dead_variables.h"
#include "verify/live_variables.h"
#include "verify/open_variables.h"
#include "verify/place.h"
#include "verify/safe_steps.h"
#include "verify/search.h"
#include "verify/witness.h"

namespace proskill::verify {

namespace {

Answer answerOf(const Goal& goal, const std::optional<Evidence>& evidence,
                const Exploration& exploration, const Witness& witness) {
  if (goal.kind == GoalKind::Unsupported) return {Truth::Unknown, std::nullopt, goal.reason};
  if (evidence) {
    auto trace = witness.trace(goal, *evidence);
    if (trace) return {Truth::False, std::move(*trace), {}};
    return {Truth::Unknown, std::nullopt, "internal error, please report it: " + trace.error()};
  }
  if (!exploration.complete) return {Truth::Unknown, std::nullopt, exploration.stopped};
  return {Truth::True, std::nullopt, {}};
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
  const System system = placed(compiled->system, relevance.cells);
  const SafeSteps safeSteps(system, compiled->goals, relevance.dropped);
  const LiveVariables liveVariables(system, compiled->goals, relevance.dropped);
  const OpenVariables openVariables(system, compiled->goals, relevance.dropped);
  const bool open = takes(Reduction::OpenVariables) && !openVariables.none();
  const Reductions reductions{.inclusion = takes(Reduction::Inclusion),
                              .safeSteps = takes(Reduction::SafeSteps) ? &safeSteps : nullptr,
                              .liveVariables =
                                  takes(Reduction::LiveVariables) ? &liveVariables : nullptr,
                              .openVariables = open ? &openVariables : nullptr,
                              .dropped = relevance.dropped};
  const auto forgetting =
      takes(Reduction::Extrapolation) ? Forgetting::LowerUpper : Forgetting::Least;
  auto found = search(system, compiled->goals, reductions, forgetting, limits);
  if (found.failure) return std::unexpected(*found.failure);
  const System whole = placed(std::move(compiled->system));
  const Witness witness(whole, reductions, provenance);
  Result result;
  for (std::size_t i = 0; i < questions.size(); ++i)
    result.answers.push_back(
        answerOf(compiled->goals[i], found.goals[i], found.statistics, witness));
  result.exploration = found.statistics;
  return result;
}

} // namespace proskill::verify
