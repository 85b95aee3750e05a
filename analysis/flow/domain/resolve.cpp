#include "analysis/flow/domain/resolve.h"

#include "analysis/flow/domain/numbers.h"

#include <utility>

namespace proskill::analysis::flow {

namespace {

using syntax::Expr;
using syntax::ExprKind;

template <class Node>
std::optional<std::size_t> indexOf(const Table<Node>& table, std::string_view name) {
  auto found = table.byName.find(name);
  if (found == table.byName.end()) return std::nullopt;
  return found->second;
}

void collectSlots(const Term& term, std::vector<Slot>& slots) {
  if (term.kind == Term::Kind::Variable && std::ranges::find(slots, term.slot) == slots.end())
    slots.push_back(term.slot);
  for (const Term& operand : term.operands) collectSlots(operand, slots);
}

void moveToFirstSlot(Term& term) {
  term.slot = 0;
  for (Term& operand : term.operands) moveToFirstSlot(operand);
}

/// Turns a comparison that reads one variable into a set of that variable's values.
Condition simplified(Condition condition) {
  if (condition.slots.size() != 1) return condition;
  const Term& variable =
      condition.terms[0].reads(condition.slots[0]) ? condition.terms[0] : condition.terms[1];
  if (variable.kind != Term::Kind::Variable) return condition;
  Slot slot = condition.slots[0];
  Condition member{.kind = Condition::Kind::Member, .slot = slot};
  const Domain& domain = *variable.domain;
  for (Term& term : condition.terms) moveToFirstSlot(term);
  condition.slots = {0};
  State one{.reachable = true, .values = {{}}};
  forEach(domain.all(), [&](unsigned index) {
    one.values[0] = ValueSet::of(index);
    if (mayHold(one, condition)) member.holds |= ValueSet::of(index);
    if (mayFail(one, condition)) member.fails |= ValueSet::of(index);
  });
  return member;
}

Comparison mirrored(Comparison comparison) {
  switch (comparison) {
  case Comparison::Less: return Comparison::Greater;
  case Comparison::LessEqual: return Comparison::GreaterEqual;
  case Comparison::Greater: return Comparison::Less;
  case Comparison::GreaterEqual: return Comparison::LessEqual;
  case Comparison::Equal:
  case Comparison::NotEqual: return comparison;
  }
  std::unreachable();
}

/// Whether it is true for some number of the span and this number.
bool mayHold(Comparison comparison, Span span, std::int64_t number) {
  switch (comparison) {
  case Comparison::Equal: return span.first <= number && number <= span.last;
  case Comparison::NotEqual: return span != Span{number, number};
  case Comparison::Less: return span.first < number;
  case Comparison::LessEqual: return span.first <= number;
  case Comparison::Greater: return span.last > number;
  case Comparison::GreaterEqual: return span.last >= number;
  }
  return true;
}

/// Whether it is false for some number of the span and this number.
bool mayFail(Comparison comparison, Span span, std::int64_t number) {
  return mayHold(negated(comparison), span, number);
}

/// Shortcut for the most common comparison, of a variable with a value; the same as `simplified`.
Condition withNumber(Comparison comparison, const Term& variable, std::int64_t number) {
  Condition member{.kind = Condition::Kind::Member, .slot = variable.slot};
  const Domain& domain = *variable.domain;
  for (unsigned index = 0; index < domain.size(); ++index) {
    if (mayHold(comparison, domain.at(index), number)) member.holds |= ValueSet::of(index);
    if (mayFail(comparison, domain.at(index), number)) member.fails |= ValueSet::of(index);
  }
  return member;
}

std::optional<Comparison> comparisonOf(ExprKind kind) {
  constexpr std::array<std::pair<ExprKind, Comparison>, 6> kComparisons{
      {{ExprKind::Equal, Comparison::Equal},
       {ExprKind::NotEqual, Comparison::NotEqual},
       {ExprKind::Less, Comparison::Less},
       {ExprKind::LessEqual, Comparison::LessEqual},
       {ExprKind::Greater, Comparison::Greater},
       {ExprKind::GreaterEqual, Comparison::GreaterEqual}}};
  const auto* found =
      std::ranges::find(kComparisons, kind, &std::pair<ExprKind, Comparison>::first);
  return found == kComparisons.end() ? std::nullopt : std::optional(found->second);
}

} // namespace

std::optional<VariableId> Resolver::stateVariable(std::string_view name) const {
  auto index = indexOf(program.stateVariables, name);
  if (!index) return std::nullopt;
  return variables.of(VariableKind::StateVariable, *index);
}

std::optional<std::size_t> Resolver::skill(std::string_view name) const {
  return indexOf(program.skills, name);
}

std::optional<VariableId> Resolver::variableOf(const Expr& expr) const {
  if (expr.kind == ExprKind::Symbol || expr.kind == ExprKind::Test)
    return stateVariable(expr.name.text);
  if (expr.kind != ExprKind::Access) return std::nullopt;
  auto index = skill(expr.name.text);
  if (!index) return std::nullopt;
  if (expr.member.text == "status") return variables.of(VariableKind::Status, *index);
  if (expr.member.text == "res") return variables.of(VariableKind::Result, *index);
  return std::nullopt;
}

void Resolver::addReads(const Expr& expr, std::vector<VariableId>& reads) const {
  if (auto variable = variableOf(expr)) reads.push_back(*variable);
  for (const Expr& operand : expr.operands) addReads(operand, reads);
}

const Inputs::Input* Resolver::inputOf(const Expr& expr, const Slots& slots) const {
  if (expr.kind != ExprKind::Parameter || !slots.skill) return nullptr;
  return inputs.find(*slots.skill, expr.name.text);
}

const Domain* Resolver::wordsOf(const Expr& expr, const Slots& slots) const {
  auto variable = variableOf(expr);
  if (const auto* input = inputOf(expr, slots)) variable = input->type;
  if (!variable || variables[*variable].domain.isNumeric()) return nullptr;
  return &variables[*variable].domain;
}

Term Resolver::term(const Expr& expr, const Domain* beside, const Slots& slots) const {
  if (auto number = wholeNumber(expr)) return {.kind = Term::Kind::Number, .number = *number};
  if (auto number = truthValue(expr)) return {.kind = Term::Kind::Number, .number = *number};
  if (expr.kind == ExprKind::Symbol && beside)
    if (auto number = beside->numberOf(expr.name.text))
      return {.kind = Term::Kind::Number, .number = *number};
  if (expr.kind == ExprKind::Symbol || expr.kind == ExprKind::Access) {
    auto variable = variableOf(expr);
    auto slot = variable ? slots.find(*variable) : std::nullopt;
    if (!slot) return {};
    return {.kind = Term::Kind::Variable, .slot = *slot, .domain = &variables[*variable].domain};
  }
  if (const auto* input = inputOf(expr, slots))
    return {.kind = Term::Kind::Any, .spans = &input->values};
  if (expr.kind != ExprKind::Add && expr.kind != ExprKind::Subtract) return {};
  Term sum{.kind = expr.kind == ExprKind::Add ? Term::Kind::Add : Term::Kind::Subtract};
  for (const Expr& operand : expr.operands) sum.operands.push_back(term(operand, nullptr, slots));
  return sum;
}

Condition Resolver::compare(Comparison comparison, const Expr& left, const Expr& right,
                            const Slots& slots) const {
  // the first variable with named values determines the meaning of the other word
  const Domain* leftWords = wordsOf(left, slots);
  const Domain* rightWords = leftWords ? nullptr : wordsOf(right, slots);
  Term first = term(left, rightWords, slots);
  Term second = term(right, leftWords, slots);
  using enum Term::Kind;
  if (first.kind == Variable && second.kind == Number)
    return withNumber(comparison, first, second.number);
  if (first.kind == Number && second.kind == Variable)
    return withNumber(mirrored(comparison), second, first.number);
  Condition condition{.kind = Condition::Kind::Compare, .comparison = comparison};
  condition.terms.push_back(std::move(first));
  condition.terms.push_back(std::move(second));
  for (const Term& each : condition.terms) {
    if (each.kind == Term::Kind::Unknown) return {};
    collectSlots(each, condition.slots);
  }
  const Domain* a = condition.terms[0].domain;
  const Domain* b = condition.terms[1].domain;
  if (a && b && a->allWords() != b->allWords()) return {};
  return simplified(std::move(condition));
}

Condition Resolver::connective(Condition::Kind kind, const Expr& expr, const Slots& slots) const {
  Condition result{.kind = kind};
  for (const Expr& operand : expr.operands) result.operands.push_back(condition(operand, slots));
  return result;
}

/// An input by itself.
Condition Resolver::truth(const Expr& parameter, const Slots& slots) const {
  const auto* input = inputOf(parameter, slots);
  if (!input || input->type) return {};
  return compare(Comparison::Equal, parameter, {.kind = ExprKind::True}, slots);
}

Condition Resolver::implication(const Expr& from, const Expr& to, const Slots& slots) const {
  Condition fails{.kind = Condition::Kind::Not, .operands = {condition(from, slots)}};
  return {.kind = Condition::Kind::Or, .operands = {std::move(fails), condition(to, slots)}};
}

Condition Resolver::condition(const Expr& expr, const Slots& slots) const {
  if (auto comparison = comparisonOf(expr.kind)) {
    if (expr.operands.size() != 2) return {};
    return compare(*comparison, expr.operands[0], expr.operands[1], slots);
  }
  switch (expr.kind) {
  case ExprKind::True: return {.kind = Condition::Kind::Constant, .constant = true};
  case ExprKind::False: return {.kind = Condition::Kind::Constant, .constant = false};
  case ExprKind::Test: {
    if (expr.operands.size() != 1) return {};
    Expr variable{.kind = ExprKind::Symbol, .name = expr.name};
    return compare(Comparison::Equal, variable, expr.operands[0], slots);
  }
  case ExprKind::And: return connective(Condition::Kind::And, expr, slots);
  case ExprKind::Or: return connective(Condition::Kind::Or, expr, slots);
  case ExprKind::Not:
    if (expr.operands.size() != 1) return {};
    return connective(Condition::Kind::Not, expr, slots);
  case ExprKind::Implies:
    if (expr.operands.size() != 2) return {};
    return implication(expr.operands[0], expr.operands[1], slots);
  case ExprKind::Equivalent:
    if (expr.operands.size() != 2) return {};
    return {.kind = Condition::Kind::And,
            .operands = {implication(expr.operands[0], expr.operands[1], slots),
                         implication(expr.operands[1], expr.operands[0], slots)}};
  case ExprKind::Parameter: return truth(expr, slots);
  case ExprKind::Missing:
  case ExprKind::Number:
  case ExprKind::Symbol:
  case ExprKind::String:
  case ExprKind::Access:
  case ExprKind::Equal:
  case ExprKind::NotEqual:
  case ExprKind::Less:
  case ExprKind::LessEqual:
  case ExprKind::Greater:
  case ExprKind::GreaterEqual:
  case ExprKind::Add:
  case ExprKind::Subtract:
  case ExprKind::Running:
  case ExprKind::Called:
  case ExprKind::Ended:
  case ExprKind::Occurs:
  case ExprKind::At:
  case ExprKind::Value:
  case ExprKind::Globally:
  case ExprKind::Finally:
  case ExprKind::Next:
  case ExprKind::Until:
  case ExprKind::WeakUntil:
  case ExprKind::Release:
  case ExprKind::StrongRelease: return {};
  }
  std::unreachable();
}

std::vector<Assignment> Resolver::assignments(const syntax::Effects& effects,
                                              const Slots& slots) const {
  std::vector<Assignment> result;
  for (const syntax::Effect& effect : effects.items) {
    auto variable = stateVariable(effect.variable.text);
    if (!variable) continue;
    const Domain& domain = variables[*variable].domain;
    result.push_back({.variable = *variable,
                      .slot = slots.find(*variable),
                      .value = term(effect.value, domain.isNumeric() ? nullptr : &domain, slots),
                      .source = &effect});
    const Domain* other = result.back().value.domain;
    if (other && other->allWords() != domain.allWords()) result.back().value = {};
  }
  return result;
}

Assignment Resolver::constant(VariableId variable, std::int64_t number, const Slots& slots) const {
  return {.variable = variable,
          .slot = slots.find(variable),
          .value = {.kind = Term::Kind::Number, .number = number}};
}

} // namespace proskill::analysis::flow
