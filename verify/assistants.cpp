#include "verify/assistants.h"

#include "verify/compile/compile.h"
#include "verify/ranks/exchange.h"
#include "verify/ranks/shared_search.h"
#include "verify/reduce/prepared.h"

#include <algorithm>

namespace proskill::verify {

namespace {

/// What rank 0 wants: a flag that is set, and questions; or an unset flag.
std::string orderFor(const std::vector<std::size_t>& questions) {
  return bytesOf([&](CheckpointWriter& to) {
    to.number(1);
    to.number(questions.size());
    for (const auto question : questions) to.number(question);
  });
}

/// The goals of the questions in an order; nothing if it dismisses.
std::optional<std::vector<Goal>> goalsOf(CheckpointReader order, const Compiled& compiled) {
  if (!order.flag()) return std::nullopt;
  std::vector<Goal> goals;
  for (auto left = order.number(); left > 0; --left)
    goals.push_back(compiled.goals[order.indexBelow(compiled.goals.size())]);
  return goals;
}

/// Takes part in one search, unless a rank cannot.
void take(const std::vector<Goal>& goals, const Compiled& compiled, const Options& options,
          LimitWatch& limits) {
  std::optional<Prepared> prepared;
  std::string problem;
  try {
    const auto may = [&](Reduction it) { return mayTake(it, options, compiled.system); };
    prepared.emplace(compiled.system, goals, may, limits);
  } catch (const LimitMet& limit) {
    problem = limit.which;
  }
  if (!firstOf(options.ranks->gather(problem)).empty()) return;
  searchByRanks(*prepared, goals, limits, *options.ranks, [](std::size_t, const Evidence&) {});
}

} // namespace

void callAssistants(Ranks& ranks, const std::vector<std::size_t>& questions) {
  (void)ranks.gather(orderFor(questions));
  if (auto problem = firstOf(ranks.gather("")); !problem.empty())
    throw LimitMet{std::move(problem)};
}

void dismissAssistants(Ranks& ranks) {
  (void)ranks.gather(bytesOf([](CheckpointWriter& to) { to.number(0); }));
}

std::expected<Result, Unsupported> assist(const fiacre::Program& program,
                                          const fiacre::Provenance& provenance,
                                          const std::vector<Question>& questions,
                                          const Options& options) {
  LimitWatch limits(options);
  const auto compiled = compile(program, provenance, questions); // without limits: rank 0 has some
  Result nothing;
  nothing.answers.resize(questions.size());
  for (;;) {
    const auto order = options.ranks->gather("")[0];
    if (!compiled) return std::unexpected(compiled.error()); // rank 0 has seen the same
    const auto goals = goalsOf(readerOf(order), *compiled);
    if (!goals) return nothing;
    take(*goals, *compiled, options, limits);
  }
}

} // namespace proskill::verify
