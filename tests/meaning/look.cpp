#include "tests/meaning/look.h"

#include <algorithm>

namespace proskill::meaning {

using syntax::Expr;
using syntax::ExprKind;

std::string_view wordOf(Status status) {
  switch (status) {
  case Status::None: return "no_status";
  case Status::Success: return "success";
  case Status::Failure: return "failure";
  case Status::FailedInvariant: return "failed_inv";
  case Status::Interrupted: return "interrupted";
  }
  return {};
}

bool Look::holds(const Expr& condition, int thread) const {
  const auto& parts = condition.operands;
  const auto part = [&](const Expr& operand) { return holds(operand, thread); };
  switch (condition.kind) {
  case ExprKind::True: return true;
  case ExprKind::False: return false;
  case ExprKind::Parameter: return given(condition) != 0;
  case ExprKind::And: return std::ranges::all_of(parts, part);
  case ExprKind::Or: return std::ranges::any_of(parts, part);
  case ExprKind::Not: return !part(parts[0]);
  case ExprKind::Implies: return !part(parts[0]) || part(parts[1]);
  case ExprKind::Equivalent: return part(parts[0]) == part(parts[1]);
  case ExprKind::Test:
  case ExprKind::Value: return hasValue(condition.name.text, parts[0]);
  case ExprKind::Equal: return equal(parts[0], parts[1], thread);
  case ExprKind::NotEqual: return !equal(parts[0], parts[1], thread);
  case ExprKind::Less: return number(parts[0]) < number(parts[1]);
  case ExprKind::LessEqual: return number(parts[0]) <= number(parts[1]);
  case ExprKind::Greater: return number(parts[0]) > number(parts[1]);
  case ExprKind::GreaterEqual: return number(parts[0]) >= number(parts[1]);
  default: return false;
  }
}

std::int64_t Look::number(const Expr& value) const {
  switch (value.kind) {
  case ExprKind::Number: return value.number.numerator;
  case ExprKind::Symbol: return now.values[script.variable(value.name.text)];
  case ExprKind::Parameter: return given(value);
  case ExprKind::Add:
  case ExprKind::Subtract: {
    const auto sign = value.kind == ExprKind::Add ? 1 : -1;
    if (value.operands.size() == 1) return sign * number(value.operands[0]);
    auto sum = number(value.operands[0]);
    for (std::size_t i = 1; i < value.operands.size(); ++i) sum += sign * number(value.operands[i]);
    return sum;
  }
  default: return 0;
  }
}

std::int64_t Look::given(const Expr& parameter) const {
  const auto [skill, slot] = script.parameters.at(&parameter);
  return now.skills[skill].given.at(slot);
}

/// The variable that it is, or whose values it has.
int Look::variableOf(const Expr& expr) const {
  if (expr.kind == ExprKind::Symbol) return script.variable(expr.name.text);
  if (expr.kind != ExprKind::Parameter) return kNobody;
  const auto [skill, slot] = script.parameters.at(&expr);
  return script.skills[skill].inputs[slot].variable;
}

std::int64_t Look::valueFor(int variable, const Expr& value) const {
  if (variable == kNobody) return holds(value) ? 1 : 0;
  if (script.variables[variable]->isNatural()) return number(value);
  return value.kind == ExprKind::Parameter ? given(value) : stateOf(variable, value.name.text);
}

bool Look::isTruth(const Expr& expr) const {
  const bool isLiteral = expr.kind == ExprKind::True || expr.kind == ExprKind::False;
  return isLiteral || (expr.kind == ExprKind::Parameter && variableOf(expr) == kNobody);
}

bool Look::isEnumeration(const Expr& expr) const {
  const int variable = variableOf(expr);
  return variable != kNobody && !script.variables[variable]->isNatural();
}

bool Look::equal(const Expr& a, const Expr& b, int thread) const {
  if (a.kind == ExprKind::Access || b.kind == ExprKind::Access)
    return wordOf(a, thread) == wordOf(b, thread);
  if (isTruth(a)) return holds(a) == holds(b);
  if (isEnumeration(a)) return number(a) == valueFor(variableOf(a), b);
  if (isEnumeration(b)) return number(b) == valueFor(variableOf(b), a);
  return number(a) == number(b);
}

bool Look::hasValue(std::string_view variable, const Expr& value) const {
  const int index = script.variable(variable);
  return now.values[index] == valueFor(index, value);
}

std::int64_t Look::stateOf(int variable, std::string_view word) const {
  const auto& states = script.variables[variable]->states;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (states[i].text == word) return static_cast<std::int64_t>(i);
  const int other = script.variable(word);
  if (other == variable) return now.values[variable];
  if (other == kNobody) return -1;
  return stateOf(variable, script.variables[other]->states[now.values[other]].text);
}

std::string_view Look::wordOf(const Expr& expr, int thread) const {
  if (expr.kind != ExprKind::Access) return expr.name.text;
  const auto outcome = outcomeOf(expr.name.text, thread);
  return expr.member.text == "res" ? outcome.result : meaning::wordOf(outcome.status);
}

Outcome Look::outcomeOf(std::string_view name, int thread) const {
  const int skill = script.skill(name);
  if (skill == kNobody) return {};
  for (int at = thread; at != kNobody; at = script.threads[at].parent)
    if (const auto own = now.own.find({at, skill}); own != now.own.end()) return own->second;
  return now.skills[skill].last;
}

bool Look::guardsHold(int skill) const {
  return std::ranges::all_of(script.skills[skill].node->invariants,
                             [&](const auto& invariant) { return holds(invariant.guard); });
}

bool Look::someGuardFails() const {
  for (int i = 0; i < static_cast<int>(script.skills.size()); ++i)
    if (now.skills[i].phase == Phase::Running && !guardsHold(i) && !lingers(i)) return true;
  return false;
}

bool Look::lingers(int skill) const {
  const int body = script.skills[skill].body;
  if (body == kNobody) return false;
  const auto& state = now.threads[body];
  if (state.control != Control::Stopping || !state.waits) return false;
  const auto& place = script.threads[body].places[state.place];
  if (place.call) return script.skills[script.skill(place.call->head.text)].holdsOut;
  return std::ranges::any_of(place.branches,
                             [&](int branch) { return script.threads[branch].holdsOut; });
}

bool Look::preconditionHolds(int skill) const {
  return std::ranges::all_of(script.skills[skill].node->preconditions,
                             [&](const auto& each) { return holds(each.condition); });
}

} // namespace proskill::meaning
