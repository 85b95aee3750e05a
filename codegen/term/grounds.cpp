#include "codegen/term/grounds.h"

#include "codegen/term/build.h"
#include "codegen/term/inputs.h"
#include "codegen/term/linear.h"
#include "fiacre/print/print.h"

#include <algorithm>

namespace proskill::codegen {
namespace {

using fiacre::Ground;

OriginId explained(Context& context, OriginId origin, Ground ground) {
  if (origin == 0) return origin;
  auto& all = context.origins.provenance.origins[origin].grounds;
  if (std::ranges::find(all, ground) == all.end()) all.push_back(std::move(ground));
  return origin;
}

/// A word, or an input as traces show it: `go.to`.
std::string shown(const Context& context, const syntax::Expr& expr) {
  if (expr.kind == syntax::ExprKind::Parameter && context.writtenIn)
    return shownInput(context.writtenIn->name(), expr.name.text);
  return std::string(expr.name.text);
}

/// `energy − 2`, in infix notation.
std::string infix(const Context& context, const syntax::Expr& expr, bool inner = false) {
  using syntax::ExprKind;
  if (expr.kind == ExprKind::Number) return syntax::toString(expr.number);
  if (expr.kind == ExprKind::Symbol || expr.kind == ExprKind::Parameter)
    return shown(context, expr);
  const bool adds = expr.kind == ExprKind::Add;
  if (!adds && expr.operands.size() == 1) return "−" + infix(context, expr.operands[0], true);
  std::string text;
  for (const auto& operand : expr.operands)
    text += (text.empty() ? "" : adds ? " + " : " − ") + infix(context, operand, true);
  return inner ? "(" + text + ")" : text;
}

} // namespace

OriginId decidedBy(Context& context, OriginId origin, const fiacre::Expr& condition, bool expected,
                   std::string text) {
  if (isTrue(condition) || isFalse(condition)) return origin;
  return explained(
      context, origin,
      {.expr = fiacre::printExpr(condition), .text = std::move(text), .expected = expected});
}

OriginId falseAfterwards(Context& context, OriginId origin, const fiacre::Expr& condition,
                         std::string text) {
  return explained(context, origin,
                   {.expr = fiacre::printExpr(condition),
                    .text = std::move(text),
                    .expected = false,
                    .afterwards = true});
}

OriginId causedBy(Context& context, OriginId origin, const fiacre::Expr& told) {
  if (isTrue(told) || isFalse(told)) return origin;
  return explained(context, origin, {.kind = Ground::Kind::Cause, .expr = fiacre::printExpr(told)});
}

OriginId waitsFor(Context& context, OriginId origin, const fiacre::Expr& condition,
                  std::string text, std::string_view resource) {
  if (isTrue(condition)) return origin;
  return explained(context, origin,
                   {.kind = Ground::Kind::Need,
                    .expr = fiacre::printExpr(condition),
                    .text = std::move(text),
                    .variable = std::string(resource)});
}

OriginId heldBy(Context& context, OriginId origin, const fiacre::Expr& condition,
                std::string_view skill, std::string_view resource) {
  return explained(context, origin,
                   {.kind = Ground::Kind::Holder,
                    .expr = fiacre::printExpr(condition),
                    .text = std::string(skill),
                    .variable = std::string(resource)});
}

OriginId triesValue(Context& context, OriginId origin, const syntax::Effect& effect) {
  const auto& variable = context.stateVariable(effect.variable.text);
  return explained(context, origin,
                   {.kind = Ground::Kind::Value,
                    .expr = fiacre::printExpr(Linear(context, effect.value).expr()),
                    .text = infix(context, effect.value),
                    .variable = std::string(effect.variable.text),
                    .bounds = domainOf(variable)});
}

OriginId triesMove(Context& context, OriginId origin, const syntax::Effect& effect) {
  auto read = name(context.names.variable(effect.variable.text));
  if (effect.value.kind == syntax::ExprKind::Parameter)
    read = equal(std::move(read), name(context.operand(effect.value)->variable));
  return explained(context, origin,
                   {.kind = Ground::Kind::Move,
                    .expr = fiacre::printExpr(read),
                    .text = shown(context, effect.value),
                    .variable = std::string(effect.variable.text)});
}

} // namespace proskill::codegen
