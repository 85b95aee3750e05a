#include "analysis/names/expressions.h"

#include "analysis/names/arguments.h"
#include "syntax/diagnostics/codes.h"
#include "syntax/diagnostics/suggest.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

namespace proskill::analysis {

using syntax::Code;
using syntax::Expr;
using syntax::ExprKind;
using syntax::Name;

namespace {

/// The keywords of a property's atoms; in a condition the parser reads them as state variables.
constexpr std::string_view kAtomWords[] = {"running", "called", "ended", "occurs", "at", "value"};

bool isAtomWord(std::string_view word) {
  return std::ranges::find(kAtomWords, word) != std::end(kAtomWords);
}

/// The statuses of a skill that has ended.
std::span<const std::string_view> endedWords() { return statusWords().subspan(1); }

/// Whether a truth value is an input, `true` or `false`, and not a condition in parentheses.
bool isOneWord(const Expr& operand) {
  return operand.kind == ExprKind::Parameter || operand.kind == ExprKind::True ||
         operand.kind == ExprKind::False;
}

} // namespace

void Expressions::condition(const Expr& expr) {
  switch (expr.kind) {
  case ExprKind::Missing:
  case ExprKind::True:
  case ExprKind::False: return;
  case ExprKind::And:
  case ExprKind::Or:
  case ExprKind::Not:
  case ExprKind::Implies:
  case ExprKind::Equivalent:
  case ExprKind::Globally:
  case ExprKind::Finally:
  case ExprKind::Next:
  case ExprKind::Until:
  case ExprKind::WeakUntil:
  case ExprKind::Release:
  case ExprKind::StrongRelease:
    for (const Expr& each : expr.operands) condition(each);
    return;
  case ExprKind::Test: return test(expr);
  case ExprKind::Equal:
  case ExprKind::NotEqual: return equality(expr);
  case ExprKind::Less:
  case ExprKind::LessEqual:
  case ExprKind::Greater:
  case ExprKind::GreaterEqual: return naturals(expr.operands);
  case ExprKind::Running:
  case ExprKind::Called:
  case ExprKind::Ended:
  case ExprKind::Occurs:
  case ExprKind::At:
  case ExprKind::Value: return atom(expr);
  case ExprKind::Parameter: return truthValue(expr);
  case ExprKind::Number:
  case ExprKind::Symbol:
  case ExprKind::String:
  case ExprKind::Access:
  case ExprKind::Add:
  case ExprKind::Subtract: return noCondition(expr);
  }
}

void Expressions::effects(const syntax::Effects& effects) {
  for (const syntax::Effect& effect : effects.items)
    valueOf(effect.variable, effect.value, Role::Write);
  if (effects.items.size() > 1) refuseRepeated(effects);
}

void Expressions::refuseRepeated(const syntax::Effects& effects) {
  std::map<std::string_view, syntax::Range> set;
  for (const syntax::Effect& effect : effects.items) {
    if (!effect.variable) continue;
    auto [first, isNew] = set.try_emplace(effect.variable.text, effect.variable.range);
    if (isNew) continue;
    context.findings
        .report(Code::DuplicateEffect, {file, effect.variable.range}, effect.variable.text)
        .related({file, first->second}, "first set here");
  }
}

Type Expressions::variable(const Name& name, Role role) {
  const SymbolId symbol = names.use(SymbolKind::StateVariable, name, role);
  return symbol == kNoSymbol ? Type{} : context.typeOfVariable(symbol);
}

Type Expressions::readVariable(const Name& name) {
  const SymbolId symbol = names.useOperand(name);
  return symbol == kNoSymbol ? Type{} : context.typeOfVariable(symbol);
}

/// `value` is compared with the variable `name`, or assigned to it.
void Expressions::valueOf(const Name& name, const Expr& value, Role role) {
  const Type wanted = variable(name, role);
  const Type given = operand(value, wanted);
  if (!comparable(wanted, given))
    context.findings.report(Code::TypeMismatch, {file, value.range},
                            describe(wanted, context.symbols), describe(given, context.symbols));
}

void Expressions::test(const Expr& expr) {
  const bool isVariable =
      context.symbols.find(SymbolKind::StateVariable, expr.name.text) != kNoSymbol;
  if (!isVariable && isAtomWord(expr.name.text)) return onlyInProperty(expr.name);
  if (expr.operands.empty())
    variable(expr.name, Role::Read);
  else
    valueOf(expr.name, expr.operands.front(), Role::Read);
}

void Expressions::equality(const Expr& expr) {
  if (expr.operands.size() < 2) return;
  auto hasOwnType = [&](const Expr& it) {
    return it.kind != ExprKind::Symbol ||
           context.symbols.find(SymbolKind::StateVariable, it.name.text) != kNoSymbol;
  };
  // the operand with a type of its own determines the meaning of the other word
  const bool swapped = !hasOwnType(expr.operands[0]) && hasOwnType(expr.operands[1]);
  const Expr& anchor = expr.operands[swapped ? 1 : 0];
  const Expr& other = expr.operands[swapped ? 0 : 1];
  const Type wanted = value(anchor);
  const Type given = operand(other, wanted);
  const bool areTruthValues =
      wanted.kind == TypeKind::Boolean && given == wanted && isOneWord(anchor) && isOneWord(other);
  if (!areTruthValues && !comparable(wanted, given))
    context.findings.report(Code::ComparedTypes, {file, expr.range}, described(anchor, wanted),
                            described(other, given));
}

std::string Expressions::described(const Expr& expr, Type type) const {
  const bool isCondition = type.kind == TypeKind::Boolean && !isOneWord(expr);
  return isCondition ? "a condition" : describe(type, context.symbols);
}

Type Expressions::value(const Expr& expr) {
  return expr.kind == ExprKind::Symbol ? readVariable(expr.name) : operand(expr, {});
}

Type Expressions::operand(const Expr& expr, Type expected) {
  switch (expr.kind) {
  case ExprKind::Missing: return {};
  case ExprKind::Number: return number(expr, expected);
  case ExprKind::Symbol: return word(expr, expected);
  case ExprKind::Access: return access(expr);
  case ExprKind::String: return {TypeKind::String, kNoSymbol};
  case ExprKind::Add:
  case ExprKind::Subtract: naturals(expr.operands); return {TypeKind::Natural, kNoSymbol};
  case ExprKind::Parameter: return parameter(expr);
  case ExprKind::True:
  case ExprKind::False:
  case ExprKind::Test:
  case ExprKind::Equal:
  case ExprKind::NotEqual:
  case ExprKind::Less:
  case ExprKind::LessEqual:
  case ExprKind::Greater:
  case ExprKind::GreaterEqual:
  case ExprKind::And:
  case ExprKind::Or:
  case ExprKind::Not:
  case ExprKind::Implies:
  case ExprKind::Equivalent:
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
  case ExprKind::StrongRelease: condition(expr); return {TypeKind::Boolean, kNoSymbol};
  }
  std::unreachable();
}

Type Expressions::word(const Expr& expr, Type expected) {
  const Name& name = expr.name;
  if (expected.kind == TypeKind::Status) return names.useStatus(name, statusWords()), expected;
  if (expected.kind == TypeKind::Result) return names.useResult(name, expected.of), expected;
  const bool isValue = expected.kind == TypeKind::Value &&
                       context.symbols.find(SymbolKind::Value, name.text, expected.of) != kNoSymbol;
  const SymbolId other = context.symbols.find(SymbolKind::StateVariable, name.text);
  if (!isValue && other != kNoSymbol) return readVariable(name);
  if (expected.kind == TypeKind::Value)
    return names.use(SymbolKind::Value, name, Role::Mention, expected.of), expected;
  if (expected.known()) readVariable(name);
  return {};
}

Type Expressions::number(const Expr& expr, Type expected) {
  const Type type = typeOfNumber(expr);
  if (type.kind != TypeKind::Natural) {
    refuse(Code::ExpectedNatural, expr, describe(type, context.symbols));
    return {};
  }
  names.checkDomain(expr, expected);
  return type;
}

Type Expressions::access(const Expr& expr) {
  const SymbolId skill = names.use(SymbolKind::Skill, expr.name, Role::Read);
  if (!expr.member || expr.member.text == "status")
    return expr.member ? Type{TypeKind::Status, kNoSymbol} : Type{};
  if (expr.member.text == "res") return skill == kNoSymbol ? Type{} : Type{TypeKind::Result, skill};
  constexpr std::string_view kMembers[] = {"status", "res"};
  context.findings.report(Code::UnknownMember, {file, expr.member.range}, expr.member.text)
      .suggest(syntax::nearest(expr.member.text, kMembers));
  return {};
}

void Expressions::naturals(const syntax::List<Expr>& operands) {
  for (const Expr& each : operands) natural(each);
}

void Expressions::natural(const Expr& expr) {
  const Type type = value(expr);
  if (type.known() && type.kind != TypeKind::Natural)
    refuse(Code::ExpectedNatural, expr, describe(type, context.symbols));
}

/// A truth value, or a parameter with the values of a state variable, is part of the verified
/// model; others only go to the platform.
Type Expressions::parameter(const Expr& expr) {
  if (skill == kNoSymbol) {
    refuse(Code::ParameterOutsideSkill, expr, std::string(expr.name.text));
    return {};
  }
  const Type type = Arguments(context, file, skill).parameter(expr.name);
  if (!type.known() || type.of != kNoSymbol || type.kind == TypeKind::Boolean) return type;
  context.findings.report(Code::ParameterInCondition, {file, expr.range}, expr.name.text,
                          describe(type, context.symbols));
  return {};
}

/// A parameter in place of a condition.
void Expressions::truthValue(const Expr& parameter) {
  const Type type = this->parameter(parameter);
  if (type.known() && type.kind != TypeKind::Boolean)
    refuse(Code::ExpectedCondition, parameter, describe(type, context.symbols));
}

void Expressions::noCondition(const Expr& expr) {
  std::string found = "the word `" + std::string(expr.name.text) + "`";
  if (expr.kind != ExprKind::Symbol) {
    const Type type = expr.kind == ExprKind::Number ? typeOfNumber(expr) : operand(expr, {});
    if (!type.known()) return;
    found = describe(type, context.symbols);
  } else if (context.symbols.find(SymbolKind::StateVariable, expr.name.text) != kNoSymbol) {
    variable(expr.name, Role::Read);
    found = "the state variable `" + std::string(expr.name.text) + "`";
  }
  refuse(Code::ExpectedCondition, expr, found);
}

void Expressions::refuse(syntax::CodeFor<1> code, const Expr& expr, const std::string& found) {
  context.findings.report(code, {file, expr.range}, found);
}

void Expressions::onlyInProperty(const Name& word) {
  context.findings.report(Code::OnlyInProperty, {file, word.range}, word.text);
}

void Expressions::atom(const Expr& expr) {
  if (atoms == Atoms::Program) return onlyInProperty(expr.head);
  if (expr.kind == ExprKind::Occurs)
    names.use(SymbolKind::Event, expr.name, Role::Mention);
  else if (expr.kind == ExprKind::At)
    names.useLabelAnywhere(expr.name);
  else if (expr.kind == ExprKind::Value)
    valueAtom(expr);
  else
    skillAtom(expr);
}

void Expressions::valueAtom(const Expr& expr) {
  if (expr.operands.empty())
    variable(expr.name, Role::Read);
  else
    valueOf(expr.name, expr.operands.front(), Role::Read);
}

/// `(running x)`, `(called x)`, `(ended x status)`.
void Expressions::skillAtom(const Expr& expr) {
  assert(expr.kind == ExprKind::Running || expr.kind == ExprKind::Called ||
         expr.kind == ExprKind::Ended);
  if (expr.kind == ExprKind::Ended) names.useStatus(expr.member, endedWords());
  names.use(SymbolKind::Skill, expr.name, Role::Read);
}

} // namespace proskill::analysis
