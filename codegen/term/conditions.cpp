#include "codegen/term/conditions.h"

#include "codegen/term/linear.h"

#include <algorithm>
#include <cassert>

namespace proskill::codegen {
namespace {

using fiacre::Op;
using syntax::ExprKind;

fiacre::Expr comparison(Context& context, Op op, const syntax::Expr& expr) {
  return Linear::compare(op, Linear(context, expr.operands[0]), Linear(context, expr.operands[1]));
}

bool isEnumeration(Context& context, const syntax::Expr& expr) {
  const auto operand = context.operand(expr);
  return operand && operand->type && !operand->type->isNatural();
}

bool isTruthValue(Context& context, const syntax::Expr& expr) {
  if (expr.kind == ExprKind::True || expr.kind == ExprKind::False) return true;
  const auto operand = context.operand(expr);
  return operand && !operand->type;
}

bool isMember(const syntax::Expr& expr, std::string_view member) {
  return expr.kind == ExprKind::Access && expr.member.text == member;
}

bool isVariable(const Context& context, const syntax::Expr& expr) {
  return expr.kind == ExprKind::Access && context.plan.find(expr.name.text);
}

/// A status, or the constant with this name. A skill that is not in the model has never run.
fiacre::Expr status(Context& context, const syntax::Expr& expr) {
  if (expr.kind != ExprKind::Access) return name(expr.name.text);
  return context.plan.find(expr.name.text) ? context.outcomeField(expr.name.text, "status")
                                           : name("no_status");
}

fiacre::Expr statusEquality(Context& context, const syntax::Expr& a, const syntax::Expr& b) {
  auto left = status(context, a);
  auto right = status(context, b);
  const bool areWords = !isVariable(context, a) && !isVariable(context, b);
  return areWords ? boolean(left == right) : equal(std::move(left), std::move(right));
}

std::vector<std::string_view> resultTags(const syntax::Skill& skill) {
  std::vector<std::string_view> tags;
  const auto add = [&](const syntax::Name& tag) {
    if (tag && std::ranges::find(tags, tag.text) == tags.end()) tags.push_back(tag.text);
  };
  for (const auto& outcome : skill.successes) add(outcome.tag);
  for (const auto& outcome : skill.failures) add(outcome.tag);
  for (const auto& invariant : skill.invariants) add(invariant.tag);
  return tags;
}

/// Whether the last outcome of a skill had this tag, whatever its status; `no_result` means that
/// there was no tag.
fiacre::Expr resultIs(Context& context, std::string_view skill, std::string_view tag) {
  const auto* plan = context.plan.find(skill);
  if (!plan) return boolean(tag == "no_result");
  const auto value = context.outcomeField(skill, "val");
  const auto& node = plan->skill();
  std::vector<fiacre::Expr> cases;
  if (tag == "no_result") cases.push_back(equal(value, name("no_result")));
  const auto addIfAny = [&](const auto& tagged, std::string_view status) {
    if (std::ranges::any_of(tagged, [&](const auto& it) { return it.tag.text == tag; }))
      cases.push_back(equal(value, context.result(skill, status, tag)));
  };
  addIfAny(node.successes, "success");
  addIfAny(node.failures, "failure");
  addIfAny(node.invariants, "failed_inv");
  return disjunction(std::move(cases));
}

/// Each skill has a result type of its own, so two results are equal if their tags are.
fiacre::Expr sameResult(Context& context, std::string_view a, std::string_view b) {
  std::vector<std::string_view> tags{"no_result"};
  if (const auto* plan = context.plan.find(a)) {
    const auto more = resultTags(plan->skill());
    tags.insert(tags.end(), more.begin(), more.end());
  }
  std::vector<fiacre::Expr> cases;
  for (const auto tag : tags)
    cases.push_back(conjunction({resultIs(context, a, tag), resultIs(context, b, tag)}));
  return disjunction(std::move(cases));
}

/// Whether the operand, which is written as `expr`, has the value, as in `(battery Low)`.
fiacre::Expr hasValue(Context& context, const Operand& operand, const syntax::Expr& expr,
                      const syntax::Expr& value) {
  if (operand.type->isNatural())
    return Linear::compare(Op::Equal, Linear(context, expr), Linear(context, value));
  auto left = name(operand.variable);
  auto right = enumerationValue(context, *operand.type, value);
  return left == right ? boolean(true) : equal(std::move(left), std::move(right));
}

fiacre::Expr test(Context& context, const syntax::Expr& expr) {
  syntax::Expr variable;
  variable.kind = ExprKind::Symbol;
  variable.name = expr.name;
  return hasValue(context, *context.operand(variable), variable, expr.operands[0]);
}

fiacre::Expr equality(Context& context, const syntax::Expr& a, const syntax::Expr& b) {
  if (isMember(a, "status") || isMember(b, "status")) return statusEquality(context, a, b);
  if (isMember(a, "res") && isMember(b, "res"))
    return sameResult(context, a.name.text, b.name.text);
  if (isMember(a, "res")) return resultIs(context, a.name.text, b.name.text);
  if (isMember(b, "res")) return resultIs(context, b.name.text, a.name.text);
  if (isTruthValue(context, a)) return equal(condition(context, a), condition(context, b));
  // the first operand that is a variable determines the meaning of the other word
  if (isEnumeration(context, a)) return hasValue(context, *context.operand(a), a, b);
  if (isEnumeration(context, b)) return hasValue(context, *context.operand(b), b, a);
  return Linear::compare(Op::Equal, Linear(context, a), Linear(context, b));
}

std::vector<fiacre::Expr> conditions(Context& context, const syntax::List<syntax::Expr>& exprs) {
  std::vector<fiacre::Expr> result;
  for (const auto& expr : exprs) result.push_back(condition(context, expr));
  return result;
}

} // namespace

fiacre::Expr enumerationValue(Context& context, const syntax::StateVariable& type,
                              const syntax::Expr& value) {
  const auto word = value.name.text;
  const bool isValue =
      value.kind == ExprKind::Symbol &&
      std::ranges::any_of(type.states, [&](const auto& it) { return it.text == word; });
  return name(isValue ? context.names.value(type.name.text, word)
                      : context.operand(value)->variable);
}

fiacre::Expr condition(Context& context, const syntax::Expr& expr) {
  switch (expr.kind) {
  case ExprKind::True: return boolean(true);
  case ExprKind::False: return boolean(false);
  case ExprKind::And: return conjunction(conditions(context, expr.operands));
  case ExprKind::Or: return disjunction(conditions(context, expr.operands));
  case ExprKind::Not: return negation(condition(context, expr.operands[0]));
  case ExprKind::Implies:
    return disjunction(
        {negation(condition(context, expr.operands[0])), condition(context, expr.operands[1])});
  case ExprKind::Equivalent:
    return equal(condition(context, expr.operands[0]), condition(context, expr.operands[1]));
  case ExprKind::Test:
  case ExprKind::Value: return test(context, expr);
  case ExprKind::Equal: return equality(context, expr.operands[0], expr.operands[1]);
  case ExprKind::NotEqual: return negation(equality(context, expr.operands[0], expr.operands[1]));
  case ExprKind::Less: return comparison(context, Op::Less, expr);
  case ExprKind::LessEqual: return comparison(context, Op::LessEqual, expr);
  case ExprKind::Greater: return comparison(context, Op::Greater, expr);
  case ExprKind::GreaterEqual: return comparison(context, Op::GreaterEqual, expr);
  case ExprKind::Parameter: return name(context.operand(expr)->variable);
  case ExprKind::Missing:
  case ExprKind::Number:
  case ExprKind::Symbol:
  case ExprKind::String:
  case ExprKind::Access:
  case ExprKind::Add:
  case ExprKind::Subtract:
  case ExprKind::Running:
  case ExprKind::Called:
  case ExprKind::Ended:
  case ExprKind::Occurs:
  case ExprKind::At:
  case ExprKind::Globally:
  case ExprKind::Finally:
  case ExprKind::Next:
  case ExprKind::Until:
  case ExprKind::WeakUntil:
  case ExprKind::Release:
  case ExprKind::StrongRelease: break;
  }
  assert(false && "not a condition of the program");
  return boolean(false);
}

fiacre::Expr conditionIn(std::string_view reader, Context& context, const syntax::Expr& expr) {
  context.reader = reader;
  auto translated = condition(context, expr);
  context.reader = {};
  return translated;
}

fiacre::Expr precondition(Context& context, const SkillPlan& skill) {
  const WrittenIn scope(context, skill);
  std::vector<fiacre::Expr> all;
  for (const auto& each : skill.skill().preconditions)
    all.push_back(condition(context, each.condition));
  return conjunction(std::move(all));
}

} // namespace proskill::codegen
