#include "fiacre/print/print.h"
#include "verify/compile/expressions.h"
#include "verify/unsupported.h"

/// Queues as values: the length, then the elements from the first to the last. Unused elements have
/// the lowest value, so that equal queues have equal parts.
namespace proskill::verify {

using fiacre::Expr;
using fiacre::Op;
using fiacre::Type;
using fiacre::TypeKind;

namespace {

const Type kTruth{.kind = TypeKind::Bool};

} // namespace

Value Expressions::queue(const Expr& expr, const Scope& scope, const Type* expected) {
  Value made = value(expr, scope, expected);
  if (made.type->kind != TypeKind::Queue) unsupported("the value is not a queue");
  return made;
}

Value Expressions::queueLiteral(const Expr& expr, const Scope& scope, const Type* expected) {
  if (!expected) unsupported("the type of a queue is not known");
  const Type& type = types.resolve(*expected);
  if (type.kind != TypeKind::Queue || expr.operands.size() > static_cast<std::size_t>(type.size))
    unsupported("a queue with more elements than places");
  const Type& element = types.resolve(type.element.at(0));
  Value made{&type, {maker.number(static_cast<std::int64_t>(expr.operands.size()))}};
  for (std::int64_t i = 0; i < type.size; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const auto part =
        at < expr.operands.size() ? value(expr.operands[at], scope, &element) : lowest(element);
    made.parts.insert(made.parts.end(), part.parts.begin(), part.parts.end());
  }
  return made;
}

/// `first` and `dequeue` of an empty queue fail.
Value Expressions::queueUnary(const Expr& expr, const Scope& scope) {
  const Value all = queue(expr.operands.at(0), scope);
  const NodeId length = all.parts.at(0);
  const NodeId none = maker.equal(length, maker.number(0));
  if (expr.op == Op::Empty) return {&kTruth, {none}};
  if (expr.op == Op::Full) return {&kTruth, {maker.equal(length, maker.number(all.type->size))}};
  const Type& element = types.resolve(all.type->element.at(0));
  const auto size = static_cast<std::ptrdiff_t>(types.scalars(element));
  const auto first = all.parts.begin() + 1;
  const auto fault =
      maker.fault("`" + fiacre::printExpr(expr) + "` of an empty queue"); // if it is one
  if (expr.op == Op::First) {
    Value made{&element, {first, first + size}};
    for (auto& part : made.parts) part = maker.require(maker.negation(none), part, fault);
    return made;
  }
  Value made{all.type,
             {maker.between(maker.binary(NodeOp::Subtract, length, maker.number(1)), 0,
                            all.type->size - 1, fault)}};
  made.parts.insert(made.parts.end(), first + size, all.parts.end());
  const Value vacant = lowest(element);
  made.parts.insert(made.parts.end(), vacant.parts.begin(), vacant.parts.end());
  return made;
}

/// `enqueue` adds at the end, `append` at the front. Both fail on a full queue.
Value Expressions::queueBinary(const Expr& expr, const Scope& scope, const Type* expected) {
  const Value all = queue(expr.operands.at(0), scope, expected);
  const Type& element = types.resolve(all.type->element.at(0));
  const std::string text = "`" + fiacre::printExpr(expr) + "`";
  const Value added =
      fitted(value(expr.operands.at(1), scope, &element), element, "an element in " + text);
  const std::size_t size = types.scalars(element);
  if (added.parts.size() != size) unsupported("an element of another type goes into a queue");
  const NodeId length = all.parts.at(0);
  Value made{all.type,
             {maker.between(maker.binary(NodeOp::Add, length, maker.number(1)), 0, all.type->size,
                            maker.fault(text + " of a full queue"))}};
  if (expr.op == Op::Append) {
    made.parts.insert(made.parts.end(), added.parts.begin(), added.parts.end());
    made.parts.insert(made.parts.end(), all.parts.begin() + 1,
                      all.parts.end() - static_cast<std::ptrdiff_t>(size));
    return made;
  }
  for (std::size_t i = 1; i < all.parts.size(); ++i) {
    const auto place = static_cast<std::int64_t>((i - 1) / size);
    made.parts.push_back(maker.conditional(maker.equal(length, maker.number(place)),
                                           added.parts[(i - 1) % size], all.parts[i]));
  }
  return made;
}

} // namespace proskill::verify
