#include "verify/compile/expressions.h"
#include "verify/unsupported.h"

#include <algorithm>

/// Unions as values: the constructor, then a place for the value of each constructor that has one.
/// Places of the others have the lowest value, so that equal unions have equal parts.
namespace proskill::verify {

using fiacre::Expr;
using fiacre::ExprKind;
using fiacre::Type;

bool Expressions::isFunction(const std::string& name) const {
  return std::ranges::find(program.functions, name, &fiacre::Function::name) !=
         program.functions.end();
}

Value Expressions::bare(const Type& type, std::int64_t number) {
  Value made = lowest(type);
  made.parts[0] = maker.number(number);
  return made;
}

/// `frame(3)`
Value Expressions::construct(const Expr& expr, const Scope& scope, const Type* expected) {
  const Type* type = expected ? &types.resolve(*expected) : nullptr;
  if (!type || !types.constructor(*type, expr.name)) type = types.unionWith(expr.name);
  if (!type)
    unsupported("`" + expr.name + "` is neither a function nor a constructor of the model");
  const auto number = types.constructor(*type, expr.name).value();
  const auto [offset, inner] = types.payload(*type, number);
  if (!inner || expr.operands.size() != 1)
    unsupported("the constructor `" + expr.name + "` has another number of values");
  Value made = bare(*type, number);
  const Value part =
      fitted(value(expr.operands[0], scope, inner), *inner, "the value of `" + expr.name + "`");
  std::ranges::copy(part.parts, made.parts.begin() + static_cast<std::ptrdiff_t>(offset));
  return made;
}

/// \pre `tested` is of a union type with this constructor, which has a value
Value Expressions::payloadOf(const Value& tested, const std::string& constructor) {
  const auto number = types.constructor(*tested.type, constructor);
  if (!number) unsupported("`" + constructor + "` is not a constructor of the value");
  const auto [offset, type] = types.payload(*tested.type, *number);
  if (!type) unsupported("the constructor `" + constructor + "` has no value");
  const auto begin = tested.parts.begin() + static_cast<std::ptrdiff_t>(offset);
  return {type, {begin, begin + static_cast<std::ptrdiff_t>(types.scalars(*type))}};
}

NodeId Expressions::matches(const Expr& pattern, const Value& tested, const Scope& scope) {
  if (isWild(pattern)) return maker.number(1);
  if (pattern.kind == ExprKind::Construct && !isFunction(pattern.name)) {
    const Value part = payloadOf(tested, pattern.name);
    const Expr& inner = pattern.operands.at(0);
    const auto number = types.constructor(*tested.type, pattern.name).value();
    const NodeId is = maker.equal(tested.parts.at(0), maker.number(number));
    const bool binds = inner.kind == ExprKind::Name && scope.contains(inner.name);
    return binds ? is : maker.both(is, matches(inner, part, scope));
  }
  const Value wanted = value(pattern, scope, tested.type);
  if (wanted.parts.size() != tested.parts.size())
    unsupported("a `case` over a value of another type than its pattern");
  NodeId all = maker.number(1);
  for (std::size_t i = 0; i < wanted.parts.size(); ++i)
    all = maker.both(all, maker.equal(tested.parts[i], wanted.parts[i]));
  return all;
}

std::vector<Expressions::Binding> Expressions::bindings(const Expr& pattern, const Value& tested,
                                                        const Scope& scope) {
  if (pattern.kind != ExprKind::Construct || isFunction(pattern.name)) return {};
  const Value part = payloadOf(tested, pattern.name);
  const Expr& inner = pattern.operands.at(0);
  if (isWild(inner)) return {};
  if (inner.kind == ExprKind::Name && scope.contains(inner.name)) return {{inner, part}};
  return bindings(inner, part, scope);
}

} // namespace proskill::verify
