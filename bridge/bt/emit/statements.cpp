#include "bridge/bt/emit/statements.h"

#include "bridge/bt/emit/elements.h"
#include "syntax/tree/statements.h"

#include <algorithm>
#include <utility>

namespace proskill::bridge::bt {

using Does = syntax::StatementKind;

namespace {

Exits labelsOf(Steps steps) {
  Exits labels;
  for (const auto& step : steps)
    if (isLabel(step)) labels.insert(exitTo(step.statement->name.text));
  return labels;
}

bool meet(const Exits& a, const Exits& b) {
  return std::ranges::any_of(a, [&](const auto& exit) { return b.contains(exit); });
}

/// A label that no jump crosses. Nothing if there is none.
std::optional<std::size_t> divisionOf(Steps steps) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!isLabel(steps[i])) continue;
    const auto before = steps.first(i);
    const auto after = steps.subspan(i + 1);
    if (!meet(jumpsOf(before), labelsOf(after)) && !meet(jumpsOf(after), labelsOf(before)))
      return i;
  }
  return {};
}

/// The number of steps up to the last one that contains a jump.
std::size_t lastJump(Steps steps, const std::string& jump) {
  auto end = steps.size();
  while (end > 0 && !jumpsOf(steps.subspan(end - 1, 1)).contains(jump)) --end;
  return end;
}

} // namespace

Element Statements::body() {
  return block(&*skill->body, {{kNext, {true}}, {kSuccess, {true}}, {kFailure, {false}}});
}

Element Statements::leave(const Result& result) {
  auto end = constant(result.value);
  if (result.script.empty()) return end;
  return inOrder(true, element("Script", {{"code", result.script}}), std::move(end));
}

Element Statements::thenNext(Element succeeding, const Results& results) {
  const auto& next = results.at(kNext);
  if (next.script.empty() && !next.value) return withResults(std::move(succeeding), false, true);
  return inOrder(true, std::move(succeeding), leave(next));
}

Element Statements::repeat(Element round, bool untilSuccess) {
  return untilSuccess
             ? element("RetryUntilSuccessful", {{"num_attempts", "-1"}}, {std::move(round)})
             : element("Repeat", {{"num_cycles", "-1"}}, {std::move(round)});
}

Element Statements::block(const syntax::Block* block, const Results& results) {
  if (!block) return leave(results.at(kNext));
  const auto all = loops.grouped(stepsOf(*block));
  return steps(all, results);
}

Element Statements::steps(Steps all, const Results& results) {
  if (all.empty()) return leave(results.at(kNext));
  if (depth == kDeepest)
    return fail(all[0].statement->range, "statements that are nested so deeply");
  ++depth;
  auto result = notTooDeep(all, results);
  --depth;
  return result;
}

Element Statements::notTooDeep(Steps all, const Results& results) {
  if (const auto label = divisionOf(all)) return atLabel(all, *label, results);
  if (std::ranges::any_of(all, isLabel)) return fail(all[0].statement->range, "jumps that cross");
  const auto exits = exitsOf(all[0]);
  const auto rest = all.subspan(1);
  if (rest.empty()) return step(all[0], results);
  if (!exits.contains(kNext)) {
    draft.note({file, rest[0].statement->range}, "statements that are never reached");
    return step(all[0], results);
  }
  if (exits.size() == 1) return row(all, results);
  return inTurn(
      exits, all[0].statement->range, results,
      [&](const Results& first) { return step(all[0], first); },
      [&](const Results& second) { return steps(rest, second); });
}

/// Steps that only go on, and then the rest.
Element Statements::row(Steps all, const Results& results) {
  auto inside = results;
  inside[kNext] = {true};
  auto sequence = constant(true);
  while (all.size() > 1 && exitsOf(all[0]) == Exits{kNext}) {
    sequence = inOrder(true, std::move(sequence), step(all[0], inside));
    all = all.subspan(1);
  }
  return inOrder(true, std::move(sequence), steps(all, results));
}

Element Statements::atLabel(Steps all, std::size_t label, const Results& results) {
  const auto& statement = *all[label].statement;
  const auto before = all.first(label);
  const auto after = all.subspan(label + 1);
  if (before.empty()) return repeated(after, statement, results);
  auto exits = exitsOf(before);
  const bool jumps = exits.erase(exitTo(statement.name.text)) > 0;
  if (jumps) exits.insert(kNext);
  return inTurn(
      exits, statement.range, results,
      [&](Results first) {
        first[exitTo(statement.name.text)] = first.at(kNext);
        return steps(before, first);
      },
      [&](const Results& second) { return repeated(after, statement, second); });
}

/// Only what comes before the last jump is repeated.
Element Statements::repeatedFirst(Steps all, std::size_t end, const syntax::Statement& label,
                                  const Results& results) {
  auto exits = exitsOf(all.first(end));
  exits.erase(exitTo(label.name.text));
  return inTurn(
      exits, label.range, results,
      [&](const Results& first) { return repeated(all.first(end), label, first); },
      [&](const Results& second) { return steps(all.subspan(end), second); });
}

std::optional<bool> Statements::common(const Exits& exits, const Results& results) {
  std::optional<bool> result;
  for (const auto& exit : exits) {
    const bool value = results.at(exit).value;
    if (result && *result != value) return std::nullopt;
    result = value;
  }
  return result.value_or(false);
}

Element Statements::withCommon(const Exits& exits, syntax::Range at, const Results& results,
                               const std::function<Element(const Results&, bool)>& part) {
  if (!std::ranges::all_of(exits, [&](const auto& exit) { return results.contains(exit); }))
    return fail(at, "jumps that cross");
  if (const auto value = common(exits, results)) return part(results, *value);
  const auto flag = fmt::format("@{}_leaves_{}", skill.name(), ++flags);
  auto inside = results;
  for (const auto& exit : exits) {
    auto& [value, script] = inside.at(exit);
    if (value) script += fmt::format("{}{} := 1", script.empty() ? "" : "; ", flag);
    value = false;
  }
  auto left =
      inOrder(false, part(inside, false), element("ScriptCondition", {{"code", flag + " == 1"}}));
  return inOrder(true, element("Script", {{"code", flag + " := 0"}}), std::move(left));
}

Element Statements::inTurn(const Exits& exits, syntax::Range at, const Results& results,
                           const Part& first, const Part& second) {
  auto others = exits;
  others.erase(kNext);
  return withCommon(others, at, results, [&](Results inside, bool other) {
    auto rest = second(inside);
    inside[kNext] = {!other};
    return inOrder(!other, first(inside), std::move(rest));
  });
}

Element Statements::repeated(Steps all, const syntax::Statement& label, const Results& results) {
  const auto again = exitTo(label.name.text);
  auto exits = exitsOf(all);
  if (exits.erase(again) == 0) return steps(all, results);
  if (exitsOf(all, Within::NoTime).contains(again))
    return fail(label.range, "a loop that may repeat without any time");
  const auto end = lastJump(all, again);
  const bool isKnown =
      std::ranges::all_of(exits, [&](const auto& exit) { return results.contains(exit); });
  if (end < all.size() && (!isKnown || !common(exits, results)))
    return repeatedFirst(all, end, label, results);
  return withCommon(exits, label.range, results, [&](Results inside, bool out) {
    inside[again] = {!out};
    return repeat(steps(all, inside), out);
  });
}

Element Statements::step(const Step& step, const Results& results) {
  if (step.counted) return counted(step, results);
  if (step.statement->kind == Does::Call) return call(step, results);
  return statement(*step.statement, results);
}

Element Statements::statement(const syntax::Statement& statement, const Results& results) {
  const auto result = [&](const std::string& exit) {
    const auto found = results.find(exit);
    if (found != results.end()) return leave(found->second);
    return fail(statement.range, "jumps that cross");
  };
  switch (statement.kind) {
  case Does::Success: return result(kSuccess);
  case Does::Failure: return result(kFailure);
  case Does::Break: return result(kBreak);
  case Does::Goto: return result(exitTo(statement.name.text));
  case Does::Call: return call({&statement}, results);
  case Does::If: return ifFrom(statement, 0, results);
  case Does::Case: return caseOf(statement, results);
  case Does::While:
  case Does::DoUntil: return loop(statement, results);
  case Does::WaitTime: return waitTime(statement, results);
  case Does::WaitCondition: return waitCondition(statement, results);
  case Does::Parallel:
  case Does::Race: return parallel(statement, results);
  case Does::Set: return set(statement, results);
  case Does::Label: return result(kNext);
  case Does::Printf: draft.note({file, statement.range}, "a message"); return result(kNext);
  case Does::Interrupt: return fail(statement.range, "an interruption of a skill");
  case Does::Emit: return fail(statement.range, "an event");
  case Does::Choose: return fail(statement.range, "a free choice");
  case Does::Unknown: return fail(statement.range, "this statement");
  }
  std::unreachable();
}

Element Statements::call(const Step& step, const Results& results) {
  auto called = calls.call(*step.statement, file);
  if (!step.decision) {
    const auto& next = results.at(kNext);
    const auto ends = calls.endsOf(step.statement->head.text);
    const bool isPlain = next.script.empty();
    if (isPlain && (next.value ? !ends.failure : !ends.success)) return called;
    if (isPlain) return withResults(std::move(called), next.value, next.value);
    if (ends.failure) called = withResults(std::move(called), true, true);
    return thenNext(std::move(called), results);
  }
  const auto* failed = afterCall(step, kFailure);
  for (const auto status : calls.statusesOf(step.statement->head.text))
    if (status != kSuccess && afterCall(step, status) != failed)
      return fail(step.decision->range, "a test that distinguishes several ways to fail");
  return either(std::move(called), afterCall(step, kSuccess), failed, results);
}

Element Statements::either(Element test, const syntax::Block* onSuccess,
                           const syntax::Block* onFailure, const Results& results) {
  if (onSuccess == onFailure)
    return inOrder(true, withResults(std::move(test), true, true), block(onSuccess, results));
  return decide(std::move(test), block(onSuccess, results), block(onFailure, results));
}

Element Statements::caseOf(const syntax::Statement& statement, const Results& results) {
  const auto* called = syntax::callOf(statement);
  if (!called) return fail(statement.range, "this statement");
  std::array<const syntax::Block*, 2> parts{};
  for (const bool succeeded : {false, true}) {
    const auto arms = calls.armsFor(statement, called->head.text, succeeded);
    if (arms.size() > 1)
      return fail(statement.range, "arms that distinguish several ways to succeed, or to fail");
    if (!arms.empty()) parts.at(succeeded ? 1 : 0) = *arms.begin();
  }
  return either(calls.call(*called, file), parts[1], parts[0], results);
}

Element Statements::ifFrom(const syntax::Statement& statement, std::size_t arm,
                           const Results& results) {
  if (arm == 0) conditions.begin();
  if (arm == statement.arms.size()) return leave(results.at(kNext));
  const auto& here = statement.arms[arm];
  if (!here.condition) return block(&here.body, results);
  auto test = conditions.another(*here.condition, file);
  auto otherwise = ifFrom(statement, arm + 1, results);
  return decide(std::move(test), block(&here.body, results), std::move(otherwise));
}

std::string Statements::milliseconds(const syntax::Interval& duration) {
  const auto exact = syntax::multiply(duration.lower, {1000, 1});
  const bool isPoint = duration.upper == duration.lower;
  if (isPoint && exact && exact->denominator == 1) return std::to_string(exact->numerator);
  fail(duration.range, "a time that is not a number of milliseconds");
  return {};
}

Element Statements::waitTime(const syntax::Statement& statement, const Results& results) {
  auto wait = element("Sleep", {{"msec", milliseconds(statement.duration)}});
  return thenNext(std::move(wait), results);
}

Element Statements::waitCondition(const syntax::Statement& statement, const Results& results) {
  if (!statement.effects.items.empty())
    return fail(statement.range, "a wait that sets variables in the same instant");
  auto wait = repeat(conditions.of(statement.condition, file), true);
  if (!syntax::hasTimeout(statement)) return thenNext(std::move(wait), results);
  auto limited =
      element("Timeout", {{"msec", milliseconds(statement.duration)}}, {std::move(wait)});
  return decide(std::move(limited), leave(results.at(kNext)),
                block(&statement.branches.front(), results));
}

/// Branches end with one result where they go on, and with the other one where they end the body.
Element Statements::parallel(const syntax::Statement& statement, const Results& results) {
  checkBranches(statement);
  auto exits = exitsOf(Step{&statement});
  const bool goesOn = exits.erase(kNext) > 0;
  return withCommon(exits, statement.range, results, [&](const Results& inside, bool out) {
    auto node = branches(statement, inside, out);
    if (!goesOn) return node;
    auto next = leave(results.at(kNext));
    return out ? decide(std::move(node), constant(true), std::move(next))
               : decide(std::move(node), std::move(next), constant(false));
  });
}

/// Those that may end at once come last: a tick in which they end the node starts none after them.
Element Statements::branches(const syntax::Statement& statement, Results results, bool out) {
  results[kNext] = {!out};
  const bool isRace = statement.kind == Does::Race;
  auto node = element("Parallel", {{"success_count", isRace || out ? "1" : "-1"},
                                   {"failure_count", isRace || !out ? "1" : "-1"}});
  std::vector<const syntax::Block*> order;
  for (const auto& branch : statement.branches) order.push_back(&branch);
  std::ranges::stable_partition(
      order, [](const auto* branch) { return exitsOf(*branch, Within::NoTime).empty(); });
  for (const auto* branch : order) node.children.push_back(block(branch, results));
  return node;
}

/// A skill that is called twice at once waits for its turn; a tree has two of it.
void Statements::checkBranches(const syntax::Statement& statement) {
  std::set<std::string_view> all;
  for (const auto& branch : statement.branches)
    for (const auto skill : calls.calledIn(branch))
      if (!all.insert(skill).second)
        fail(statement.range, fmt::format("two branches that call `{}`", skill));
}

Element Statements::set(const syntax::Statement& statement, const Results& results) {
  auto script = element("Script", {{"code", conditions.script(statement.effects, file)}});
  return thenNext(std::move(script), results);
}

Element Statements::fail(syntax::Range at, std::string_view what) {
  draft.fail({file, at}, what);
  return constant(true);
}

} // namespace proskill::bridge::bt
