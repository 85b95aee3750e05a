#include "verify/verify.h"

#include "verify/compile.h"
#include "verify/explorer.h"
#include "verify/place.h"

namespace proskill::verify {

namespace {

Answer answerOf(const Goal& goal, const Found& found, const Exploration& exploration) {
  if (goal.kind == GoalKind::Unsupported) return {Truth::Unknown, std::nullopt, goal.reason};
  if (found.decided) return {Truth::False, std::nullopt, {}};
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
  System system = placed(compiled->system);
  Reductions reductions;
  reductions.inclusion = options.reductions.contains(Reduction::Inclusion);
  auto forgetting = options.reductions.contains(Reduction::Extrapolation) ? Forgetting::LowerUpper
                                                                          : Forgetting::Least;
  Explorer explorer(system, compiled->goals, reductions, forgetting, limits);
  auto explored = explorer.run();
  if (!explored.failure.empty())
    return std::unexpected(Unsupported{explored.failure, explored.failureOrigin});
  Result result;
  for (std::size_t i = 0; i < questions.size(); ++i)
    result.answers.push_back(answerOf(compiled->goals[i], explored.goals[i], explored.statistics));
  result.exploration = explored.statistics;
  return result;
}

} // namespace proskill::verify
