#include "analysis/program/outcomes.h"

#include "syntax/tree/statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace proskill::analysis {

namespace {

using syntax::Block;
using syntax::ExprKind;
using syntax::Statement;
using syntax::StatementKind;

bool hasBreak(const Block& block) {
  bool found = false;
  syntax::forEachStatement(
      block, [&](const Statement& each) { found |= each.kind == StatementKind::Break; });
  return found;
}

bool mayRunOff(const Block& block);

bool someArmRunsOff(const Statement& statement) {
  return std::ranges::any_of(statement.arms, [](const auto& arm) { return mayRunOff(arm.body); });
}

bool isForEver(const Statement& loop, ExprKind condition) {
  return loop.condition.kind == condition && !hasBreak(loop.branches[0]);
}

/// Whether control may reach the statement after this one.
bool mayGoOn(const Statement& statement) {
  switch (statement.kind) {
  case StatementKind::Success:
  case StatementKind::Failure:
  case StatementKind::Goto:
  case StatementKind::Break: return false;
  case StatementKind::While: return !isForEver(statement, ExprKind::True);
  case StatementKind::DoUntil: return !isForEver(statement, ExprKind::False);
  case StatementKind::If: return statement.arms.back().condition || someArmRunsOff(statement);
  case StatementKind::Case: return someArmRunsOff(statement);
  case StatementKind::Unknown:
  case StatementKind::Call:
  case StatementKind::Interrupt:
  case StatementKind::WaitCondition:
  case StatementKind::WaitTime:
  case StatementKind::Label:
  case StatementKind::Parallel:
  case StatementKind::Race:
  case StatementKind::Set:
  case StatementKind::Printf:
  case StatementKind::Emit:
  case StatementKind::Choose: return true;
  }
  std::unreachable();
}

bool mayRunOff(const Block& block) {
  return block.statements.empty() || mayGoOn(block.statements.back());
}

template <class Tagged>
void add(std::vector<CallOutcome>& all, std::string_view status, const Tagged& tagged) {
  for (const auto& each : tagged) all.push_back({status, each.tag.text});
}

} // namespace

std::vector<CallOutcome> outcomesOf(const syntax::Skill& skill) {
  std::vector<CallOutcome> all;
  add(all, "success", skill.successes);
  if (skill.body ? mayRunOff(*skill.body) : all.empty()) all.push_back({"success", {}});
  add(all, "failure", skill.failures);
  add(all, "failed_inv", skill.invariants);
  if (skill.interrupt) all.push_back({"interrupted", {}});
  if (!skill.preconditions.empty()) all.push_back({"refused", {}});
  return all;
}

bool matches(const syntax::CasePattern& pattern, const CallOutcome& outcome) {
  if (pattern.status.text == "else") return true;
  if (pattern.status.text != outcome.status) return false;
  return pattern.tags.empty() ||
         std::ranges::find(pattern.tags, outcome.tag, &syntax::Name::text) != pattern.tags.end();
}

std::string toString(const CallOutcome& outcome) {
  if (outcome.tag.empty()) return std::string(outcome.status);
  return fmt::format("({} {})", outcome.status, outcome.tag);
}

} // namespace proskill::analysis
