#include "codegen/property/properties.h"
#include "fiacre/syntax/formula.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace proskill::codegen {
namespace {

using fiacre::LtlKind;
using fiacre::PatternKind;
using syntax::ExprKind;
using syntax::PropertyKind;

PatternKind kindOf(PropertyKind kind) {
  switch (kind) {
  case PropertyKind::Always: return PatternKind::Always;
  case PropertyKind::AlwaysReachable: return PatternKind::AlwaysReachable;
  case PropertyKind::Longest: return PatternKind::Longest;
  case PropertyKind::Shortest: return PatternKind::Shortest;
  case PropertyKind::DeadlockFree: return PatternKind::DeadlockFree;
  case PropertyKind::InfinitelyOften: return PatternKind::InfinitelyOften;
  case PropertyKind::LeadsTo: return PatternKind::LeadsTo;
  case PropertyKind::Precedes: return PatternKind::Precedes;
  case PropertyKind::Present: return PatternKind::Present;
  case PropertyKind::Ltl: return PatternKind::Ltl;
  case PropertyKind::Missing:
  case PropertyKind::Never:
  case PropertyKind::Reachable:
  case PropertyKind::Absent: return PatternKind::Absent;
  }
  std::unreachable();
}

LtlKind kindOf(ExprKind kind) {
  switch (kind) {
  case ExprKind::Globally: return LtlKind::Globally;
  case ExprKind::Finally: return LtlKind::Finally;
  case ExprKind::Next: return LtlKind::Next;
  case ExprKind::Until: return LtlKind::Until;
  case ExprKind::Not: return LtlKind::Not;
  case ExprKind::And: return LtlKind::And;
  case ExprKind::Or: return LtlKind::Or;
  case ExprKind::Implies: return LtlKind::Implies;
  case ExprKind::Equivalent: return LtlKind::And; // conjunction of both implications
  case ExprKind::WeakUntil: return LtlKind::Or;   // see `derived` for this one and the next two
  case ExprKind::Release: return LtlKind::Not;
  case ExprKind::StrongRelease: return LtlKind::Until;
  case ExprKind::Missing:
  case ExprKind::True:
  case ExprKind::False:
  case ExprKind::Number:
  case ExprKind::Symbol:
  case ExprKind::String:
  case ExprKind::Parameter:
  case ExprKind::Access:
  case ExprKind::Test:
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
  case ExprKind::Value: break;
  }
  assert(false && "not an operator of LTL");
  return LtlKind::Atom;
}

bool isTemporal(const syntax::Expr& expr) {
  constexpr std::array kTemporal{ExprKind::Globally,     ExprKind::Finally,   ExprKind::Next,
                                 ExprKind::Until,        ExprKind::WeakUntil, ExprKind::Release,
                                 ExprKind::StrongRelease};
  return std::ranges::find(kTemporal, expr.kind) != kTemporal.end() ||
         std::ranges::any_of(expr.operands, isTemporal);
}

std::vector<fiacre::Ltl> bothWays(std::vector<fiacre::Ltl> sides) {
  fiacre::Ltl there;
  there.kind = LtlKind::Implies;
  there.operands = sides;
  fiacre::Ltl back;
  back.kind = LtlKind::Implies;
  back.operands = {std::move(sides[1]), std::move(sides[0])};
  return {std::move(there), std::move(back)};
}

fiacre::Observable compound(fiacre::ObservableKind kind, fiacre::Observable a,
                            fiacre::Observable b) {
  fiacre::Observable both;
  both.kind = kind;
  both.operands = {std::move(a), std::move(b)};
  return both;
}

fiacre::Ltl atomOf(fiacre::Observable atom) {
  fiacre::Ltl ltl;
  ltl.atom = std::move(atom);
  return ltl;
}

fiacre::Ltl operation(LtlKind kind, fiacre::Ltl a, fiacre::Ltl b) {
  return {.kind = kind, .operands = fiacre::operandsOf(std::move(a), std::move(b))};
}

fiacre::Ltl both(fiacre::Ltl a, fiacre::Ltl b) {
  if (!fiacre::isAtom(a) || !fiacre::isAtom(b))
    return operation(LtlKind::And, std::move(a), std::move(b));
  return atomOf(compound(fiacre::ObservableKind::And, std::move(a.atom), std::move(b.atom)));
}

/// The operators that Fiacre lacks, by those that it has: `a W b` is `(a until b) or [] a`, `a R b`
/// is `not (not a until not b)`, `a M b` is `b until (a and b)`.
fiacre::Ltl derived(ExprKind kind, fiacre::Ltl a, fiacre::Ltl b) {
  if (kind == ExprKind::Release)
    return fiacre::negated(
        operation(LtlKind::Until, fiacre::negated(std::move(a)), fiacre::negated(std::move(b))));
  if (kind == ExprKind::StrongRelease) return operation(LtlKind::Until, b, both(std::move(a), b));
  fiacre::Ltl always = {.kind = LtlKind::Globally, .operands = {a}};
  return operation(LtlKind::Or, operation(LtlKind::Until, std::move(a), std::move(b)),
                   std::move(always));
}

fiacre::Ltl formula(Observer& observer, const syntax::Expr& expr) {
  fiacre::Ltl ltl;
  if (!isTemporal(expr)) {
    ltl.atom = observer.condition(expr);
    return ltl;
  }
  ltl.kind = kindOf(expr.kind);
  for (const auto& operand : expr.operands) ltl.operands.push_back(formula(observer, operand));
  if (expr.kind == ExprKind::Equivalent) ltl.operands = bothWays(std::move(ltl.operands));
  if (expr.kind > ExprKind::Until)
    return derived(expr.kind, std::move(ltl.operands[0]), std::move(ltl.operands[1]));
  return ltl;
}

/// Makes runs begin after initial values have been chosen.
void beginWhere(const fiacre::Observable& begun, fiacre::Pattern& pattern) {
  using fiacre::ObservableKind;
  const bool always = pattern.kind == PatternKind::Always;
  const auto kind = always ? ObservableKind::Implies : ObservableKind::And;
  for (auto& operand : pattern.operands) operand = compound(kind, begun, std::move(operand));
  for (auto* scope : {&pattern.after, &pattern.before})
    if (*scope) **scope = compound(ObservableKind::And, begun, std::move(**scope));
  if (pattern.kind != PatternKind::Ltl) return;
  fiacre::Ltl first;
  if (fiacre::isAtom(pattern.ltl))
    first = atomOf(compound(ObservableKind::And, begun, std::move(pattern.ltl.atom)));
  else
    first = {.kind = LtlKind::And,
             .operands = fiacre::operandsOf(atomOf(begun), std::move(pattern.ltl))};
  pattern.ltl = {.kind = LtlKind::Until,
                 .operands = fiacre::operandsOf(fiacre::negated(atomOf(begun)), std::move(first))};
}

} // namespace

fiacre::Pattern patternOf(Context& context, Observer& observer, const syntax::Property& property) {
  fiacre::Pattern pattern;
  pattern.kind = kindOf(property.kind);
  if (pattern.kind == PatternKind::Ltl)
    pattern.ltl = formula(observer, property.operands[0]);
  else
    for (const auto& operand : property.operands)
      pattern.operands.push_back(observer.condition(operand));
  if (property.after) pattern.after = observer.condition(*property.after);
  if (property.before) pattern.before = observer.condition(*property.before);
  if (property.within) pattern.within = context.times.interval(*property.within);
  if (property.forDuration) pattern.forInterval = context.times.interval(*property.forDuration);
  if (property.lasting) pattern.lasting = context.times.units(property.lasting->number);
  if (const auto begun = observer.begun()) beginWhere(*begun, pattern);
  return pattern;
}

} // namespace proskill::codegen
