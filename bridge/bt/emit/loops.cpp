#include "bridge/bt/emit/elements.h"
#include "bridge/bt/emit/statements.h"

#include <algorithm>
#include <utility>

namespace proskill::bridge::bt {
namespace {

constexpr auto kAgain = "again"; // no label: those begin with `goto`

} // namespace

Element Statements::loop(const syntax::Statement& loop, const Results& results) {
  if (exitsOf(loop.branches.front(), Within::NoTime).contains(kNext))
    return fail(loop.range, "a loop that may repeat without any time");
  return withCommon(exitsOf(Step{&loop}), loop.range, results, [&](Results inside, bool out) {
    inside[kAgain] = {!out};
    inside[kBreak] = inside.at(kNext);
    return repeat(round(loop, inside), out);
  });
}

Element Statements::round(const syntax::Statement& loop, const Results& results) {
  const auto& body = loop.branches.front();
  const auto& next = results.at(kNext);
  const auto& again = results.at(kAgain);
  if (loop.kind == syntax::StatementKind::While) {
    auto inside = results;
    inside[kNext] = again;
    auto test = conditions.of(loop.condition, file);
    return decide(std::move(test), block(&body, inside), leave(next));
  }
  return inTurn(
      exitsOf(body), loop.range, results, [&](const Results& first) { return block(&body, first); },
      [&](const Results& second) {
        return decide(conditions.of(loop.condition, file), leave(second.at(kNext)),
                      leave(second.at(kAgain)));
      });
}

/// After the last round, the node has the result of the round, with which it goes on.
Element Statements::counted(const Step& step, const Results& results) {
  const auto& loop = *step.counted;
  const auto at = step.statement->range;
  if (loop.spent) return withRecovery(loop, at, results);
  return inTurn(
      exitsOf(step), at, results,
      [&](const Results& inside) {
        const bool goesOn = inside.at(kNext).value;
        return element(goesOn ? "Repeat" : "RetryUntilSuccessful",
                       {{goesOn ? "num_cycles" : "num_attempts", std::to_string(loop.times)}},
                       {steps(loop.round, inside)});
      },
      [&](const Results& rest) { return leave(rest.at(kNext)); });
}

/// A round leaves the loop by a success of the node, a recovery and the last round by a failure.
Element Statements::withRecovery(const Counted& loop, syntax::Range at, const Results& results) {
  const auto& spent = *loop.spent;
  auto exits = exitsOf(Steps(loop.round));
  exits.erase(kNext);
  const auto isKnown = [&](const auto& exit) { return results.contains(exit); };
  if (!std::ranges::all_of(exits, isKnown) || !std::ranges::all_of(exitsOf(spent), isKnown))
    return fail(at, "jumps that cross");
  auto inRound = results;
  inRound[kNext] = {false};
  for (const auto& exit : exits) inRound[exit] = {true};
  auto inRecovery = results;
  for (const auto& exit : exitsOf(spent)) inRecovery[exit] = {false};
  inRecovery[kNext] = {true};
  auto node = element("RecoveryNode", {{"number_of_retries", std::to_string(loop.times)}},
                      {steps(loop.round, inRound), steps(loop.recovery, inRecovery)});
  auto failed = block(&spent, results);
  if (exits.empty()) return inOrder(false, std::move(node), std::move(failed));
  return decide(std::move(node), leave(results.at(*exits.begin())), std::move(failed));
}

} // namespace proskill::bridge::bt
