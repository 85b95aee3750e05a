#include "bridge/bt/emit/exits.h"

#include "bridge/bt/emit/counted.h"

#include "syntax/tree/statements.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace proskill::bridge::bt {
namespace {

using syntax::ExprKind;
using syntax::Statement;
using syntax::StatementKind;

/// What a test of a call's status says; nothing if it is another test.
std::optional<bool> underStatus(const syntax::Expr& test, std::string_view skill,
                                std::string_view ended) {
  if (test.kind == ExprKind::Not) {
    const auto inner = underStatus(test.operands.front(), skill, ended);
    return inner ? std::optional(!*inner) : std::nullopt;
  }
  if (test.kind != ExprKind::Equal && test.kind != ExprKind::NotEqual) return {};
  const auto* access = &test.operands.front();
  const auto* status = &test.operands.back();
  if (access->kind != ExprKind::Access) std::swap(access, status);
  if (access->kind != ExprKind::Access || access->name.text != skill ||
      access->member.text != "status" || status->kind != ExprKind::Symbol)
    return {};
  const bool equal = status->name.text == ended;
  return equal == (test.kind == ExprKind::Equal);
}

bool testsOnly(const Statement& statement, std::string_view skill) {
  return statement.kind == StatementKind::If &&
         std::ranges::all_of(statement.arms, [&](const syntax::Arm& arm) {
           return !arm.condition || underStatus(*arm.condition, skill, kSuccess);
         });
}

void add(Exits& exits, const Exits& more) { exits.insert(more.begin(), more.end()); }

Exits ofParts(const Statement& statement, Within within) {
  Exits exits;
  for (const auto& branch : statement.branches) add(exits, exitsOf(branch, within));
  for (const auto& arm : statement.arms) add(exits, exitsOf(arm.body, within));
  return exits;
}

bool isCovered(const Statement& statement) {
  return !statement.arms.empty() && !statement.arms.back().condition;
}

Exits ofLoop(const Statement& loop, Within within) {
  auto exits = ofParts(loop, within);
  const bool isWhile = loop.kind == StatementKind::While;
  const bool isTested = isWhile || exits.contains(kNext);
  const bool mayEnd = loop.condition.kind != (isWhile ? ExprKind::True : ExprKind::False);
  const bool isLeft = exits.erase(kBreak) > 0 || (isTested && mayEnd);
  exits.erase(kNext);
  if (isLeft) exits.insert(kNext);
  return exits;
}

Exits ofParallel(const Statement& statement, Within within) {
  Exits exits;
  bool goesOn = true;
  for (const auto& branch : statement.branches) {
    const auto own = exitsOf(branch, within);
    goesOn = goesOn && own.contains(kNext);
    add(exits, own);
  }
  if (!goesOn) exits.erase(kNext);
  return exits;
}

/// A loop without a `spent` block goes on after its last round.
Exits ofCounted(const Counted& loop, Within within) {
  auto exits = exitsOf(Steps(loop.round), within);
  const bool isSpent = loop.spent != nullptr && exits.erase(kNext) > 0;
  if (isSpent) add(exits, exitsOf(*loop.spent, within));
  if (isSpent && within == Within::AnyTime) {
    add(exits, exitsOf(Steps(loop.recovery), within));
    exits.erase(kNext);
  }
  return exits;
}

/// Whether it lasts. A call does unless its skill is known to last 0 s, which is unusual.
bool lasts(const Statement& statement) {
  if (statement.kind == StatementKind::WaitTime)
    return statement.duration.lower > syntax::Rational{0, 1};
  return statement.kind == StatementKind::Call || statement.kind == StatementKind::Case;
}

Exits ofStatement(const Statement& statement, Within within) {
  if (within == Within::NoTime && lasts(statement)) return {};
  switch (statement.kind) {
  case StatementKind::Success: return {kSuccess};
  case StatementKind::Failure: return {kFailure};
  case StatementKind::Break: return {kBreak};
  case StatementKind::Goto: return {exitTo(statement.name.text)};
  case StatementKind::While:
  case StatementKind::DoUntil: return ofLoop(statement, within);
  case StatementKind::Parallel: return ofParallel(statement, within);
  case StatementKind::Race:
  case StatementKind::Choose: return ofParts(statement, within);
  case StatementKind::If:
  case StatementKind::Case: {
    Exits exits;
    for (const auto& arm : statement.arms) add(exits, exitsOf(arm.body, within));
    if (statement.kind == StatementKind::If && !isCovered(statement)) exits.insert(kNext);
    return exits;
  }
  case StatementKind::WaitCondition: {
    auto exits = within == Within::AnyTime ? ofParts(statement, within) : Exits();
    exits.insert(kNext);
    return exits;
  }
  case StatementKind::Unknown:
  case StatementKind::Call:
  case StatementKind::Interrupt:
  case StatementKind::WaitTime:
  case StatementKind::Label:
  case StatementKind::Set:
  case StatementKind::Printf:
  case StatementKind::Emit: return {kNext};
  }
  std::unreachable();
}

} // namespace

std::string exitTo(std::string_view label) { return "goto " + std::string(label); }

std::vector<Step> stepsOf(const syntax::Block& block) {
  std::vector<Step> steps;
  for (const auto& statement : block.statements) {
    const bool decides = !steps.empty() && !steps.back().decision &&
                         steps.back().statement->kind == StatementKind::Call &&
                         testsOnly(statement, steps.back().statement->head.text);
    if (decides)
      steps.back().decision = &statement;
    else
      steps.push_back({&statement});
  }
  return steps;
}

const syntax::Block* afterCall(const Step& step, std::string_view status) {
  for (const auto& arm : step.decision->arms)
    if (!arm.condition ||
        underStatus(*arm.condition, step.statement->head.text, status).value_or(false))
      return &arm.body;
  return nullptr;
}

Exits exitsOf(const Step& step, Within within) {
  if (step.counted) return ofCounted(*step.counted, within);
  if (!step.decision) return ofStatement(*step.statement, within);
  if (within == Within::NoTime) return {};
  Exits exits;
  for (const auto* part : std::set{afterCall(step, kSuccess), afterCall(step, kFailure)})
    add(exits, part ? exitsOf(*part, within) : Exits{kNext});
  return exits;
}

Exits exitsOf(const syntax::Block& block, Within within) { return exitsOf(stepsOf(block), within); }

Exits exitsOf(Steps steps, Within within) {
  const auto jumps = jumpsOf(steps);
  Exits exits;
  bool isReached = true;
  for (const auto& step : steps) {
    if (isLabel(step) && jumps.contains(exitTo(step.statement->name.text))) isReached = true;
    if (isLabel(step) || !isReached) continue;
    auto own = exitsOf(step, within);
    isReached = own.erase(kNext) > 0;
    add(exits, own);
  }
  for (const auto& step : steps)
    if (isLabel(step)) exits.erase(exitTo(step.statement->name.text));
  if (isReached) exits.insert(kNext);
  return exits;
}

Exits jumpsOf(Steps steps) {
  Exits jumps;
  const auto visit = [&](const Statement& each) {
    if (each.kind == StatementKind::Goto) jumps.insert(exitTo(each.name.text));
  };
  for (const auto& step : steps) {
    if (step.counted) {
      add(jumps, jumpsOf(step.counted->round));
      add(jumps, jumpsOf(step.counted->recovery));
      if (step.counted->spent) add(jumps, exitsOf(*step.counted->spent));
      continue;
    }
    for (const auto* part : {step.statement, step.decision}) {
      if (!part) continue;
      visit(*part);
      for (const auto& branch : part->branches) syntax::forEachStatement(branch, visit);
      for (const auto& arm : part->arms) syntax::forEachStatement(arm.body, visit);
    }
  }
  return jumps;
}

} // namespace proskill::bridge::bt
