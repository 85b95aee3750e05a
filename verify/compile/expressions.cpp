#include "verify/compile/expressions.h"

#include "fiacre/print/print.h"
#include "verify/unsupported.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

using fiacre::Expr;
using fiacre::ExprKind;
using fiacre::Op;
using fiacre::Type;
using fiacre::TypeKind;

namespace {

const Type kBool{.kind = TypeKind::Bool};
const Type kInt{.kind = TypeKind::Int};

} // namespace

Expressions::Expressions(const fiacre::Program& of, const Types& known, System& in)
    : program(of), types(known), system(in), maker(in) {}

NodeId Expressions::scalar(const Expr& expr, const Scope& scope, const Type* expected) {
  Value all = value(expr, scope, expected);
  if (all.parts.size() != 1) unsupported("expected a single value, found one with several parts");
  return all.parts[0];
}

Value Expressions::value(const Expr& expr, const Scope& scope, const Type* expected) {
  switch (expr.kind) {
  case ExprKind::Bool: return {&kBool, {maker.number(expr.number)}};
  case ExprKind::Number: return {&kInt, {maker.number(expr.number)}};
  case ExprKind::Name: return name(expr.name, scope, expected);
  case ExprKind::Construct:
    return isFunction(expr.name) ? call(expr, scope) : construct(expr, scope, expected);
  case ExprKind::Unary: return unary(expr, scope);
  case ExprKind::Binary:
    if (expr.op == Op::Enqueue || expr.op == Op::Append) return queueBinary(expr, scope, expected);
    return binary(expr, scope);
  case ExprKind::Conditional: return conditional(expr, scope, expected);
  case ExprKind::Index: return index(expr, scope);
  case ExprKind::Field: return field(expr, scope);
  case ExprKind::Array:
  case ExprKind::Record: return literal(expr, scope, expected);
  case ExprKind::Queue: return queueLiteral(expr, scope, expected);
  }
  unsupported("an unknown kind of expression");
}

Value Expressions::name(const std::string& text, const Scope& scope, const Type* expected) {
  if (auto found = scope.find(text); found != scope.end()) return found->second;
  if (expected)
    if (auto number = types.constructor(*expected, text))
      return bare(types.resolve(*expected), *number);
  auto constant = std::ranges::find(program.constants, text, &fiacre::Constant::name);
  if (constant != program.constants.end()) {
    Value made = value(constant->value, {}, &types.resolve(constant->type));
    return {&types.resolve(constant->type), made.parts};
  }
  if (const Type* owner = types.unionWith(text))
    return bare(*owner, types.constructor(*owner, text).value());
  unsupported("`" + text + "` is not known");
}

Value Expressions::unary(const Expr& expr, const Scope& scope) {
  if (expr.op == Op::Empty || expr.op == Op::Full || expr.op == Op::First || expr.op == Op::Dequeue)
    return queueUnary(expr, scope);
  NodeId a = scalar(expr.operands.at(0), scope);
  switch (expr.op) {
  case Op::Not: return {&kBool, {maker.negation(a)}};
  case Op::Negate: return {&kInt, {maker.unary(NodeOp::Negate, a)}};
  case Op::Coerce: return {&kInt, {a}};
  case Op::Empty:
  case Op::Full:
  case Op::First:
  case Op::Dequeue:
  case Op::And:
  case Op::Or:
  case Op::Equal:
  case Op::NotEqual:
  case Op::Less:
  case Op::LessEqual:
  case Op::Greater:
  case Op::GreaterEqual:
  case Op::Add:
  case Op::Subtract:
  case Op::Multiply:
  case Op::Divide:
  case Op::Modulo:
  case Op::Enqueue:
  case Op::Append: unsupported("an unknown operator");
  }
  std::unreachable();
}

bool Expressions::isBareConstructor(const Expr& expr, const Scope& scope) const {
  if (expr.kind == ExprKind::Construct) return !isFunction(expr.name);
  return expr.kind == ExprKind::Name && !scope.contains(expr.name);
}

Value Expressions::equality(const Expr& expr, const Scope& scope) {
  const Expr* first = &expr.operands.at(0);
  const Expr* second = &expr.operands.at(1);
  if (isBareConstructor(*first, scope)) std::swap(first, second);
  Value a = value(*first, scope);
  Value b = value(*second, scope, a.type);
  if (a.parts.size() != b.parts.size()) unsupported("values of different types are compared");
  NodeId all = maker.number(1);
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    all = maker.both(all, maker.equal(a.parts[i], b.parts[i]));
  return {&kBool, {expr.op == Op::Equal ? all : maker.negation(all)}};
}

Value Expressions::binary(const Expr& expr, const Scope& scope) {
  if (expr.op == Op::Equal || expr.op == Op::NotEqual) return equality(expr, scope);
  NodeId a = scalar(expr.operands.at(0), scope);
  NodeId b = scalar(expr.operands.at(1), scope);
  switch (expr.op) {
  case Op::And: return {&kBool, {maker.both(a, b)}};
  case Op::Or: return {&kBool, {maker.binary(NodeOp::Or, a, b)}};
  case Op::Less: return {&kBool, {maker.binary(NodeOp::Less, a, b)}};
  case Op::LessEqual: return {&kBool, {maker.binary(NodeOp::LessEqual, a, b)}};
  case Op::Greater: return {&kBool, {maker.binary(NodeOp::Less, b, a)}};
  case Op::GreaterEqual: return {&kBool, {maker.binary(NodeOp::LessEqual, b, a)}};
  case Op::Add: return {&kInt, {maker.binary(NodeOp::Add, a, b)}};
  case Op::Subtract: return {&kInt, {maker.binary(NodeOp::Subtract, a, b)}};
  case Op::Multiply: return {&kInt, {maker.binary(NodeOp::Multiply, a, b)}};
  case Op::Divide: return {&kInt, {maker.binary(NodeOp::Divide, a, b)}};
  case Op::Modulo: return {&kInt, {maker.binary(NodeOp::Modulo, a, b)}};
  case Op::Not:
  case Op::Negate:
  case Op::Coerce:
  case Op::Empty:
  case Op::Full:
  case Op::First:
  case Op::Dequeue:
  case Op::Equal:
  case Op::NotEqual:
  case Op::Enqueue:
  case Op::Append: unsupported("an unknown operator");
  }
  std::unreachable();
}

Value Expressions::choose(NodeId condition, const Value& then, const Value& otherwise) {
  if (then.parts.size() != otherwise.parts.size())
    unsupported("the two sides of a choice have different types");
  Value chosen{then.type, {}};
  for (std::size_t i = 0; i < then.parts.size(); ++i)
    chosen.parts.push_back(maker.conditional(condition, then.parts[i], otherwise.parts[i]));
  return chosen;
}

Value Expressions::conditional(const Expr& expr, const Scope& scope, const Type* expected) {
  return choose(scalar(expr.operands.at(0), scope), value(expr.operands.at(1), scope, expected),
                value(expr.operands.at(2), scope, expected));
}

NodeId Expressions::indexNode(const Expr& indexed, const Scope& scope, std::int64_t size) {
  const NodeId at = scalar(indexed.operands.at(1), scope);
  const auto bounds = valueBounds(system, at);
  if (0 <= bounds.low && bounds.high < size) return at;
  return maker.between(at, 0, size - 1,
                       maker.fault("the index of `" + fiacre::printExpr(indexed) +
                                   "` lies outside of 0.." + std::to_string(size - 1)));
}

Value Expressions::fitted(Value value, const Type& type, const std::string& what) {
  std::vector<const Type*> scalarTypes;
  types.flatten(type, scalarTypes);
  if (value.parts.size() != scalarTypes.size()) unsupported(what + " gets a value of another type");
  for (std::size_t i = 0; i < value.parts.size(); ++i) {
    const auto range = types.bounds(*scalarTypes[i]);
    const auto bounds = valueBounds(system, value.parts[i]);
    if (range.low <= bounds.low && bounds.high <= range.high) continue;
    value.parts[i] =
        maker.between(value.parts[i], range.low, range.high,
                      maker.fault(what + " gets a value outside of " + std::to_string(range.low) +
                                  ".." + std::to_string(range.high)));
  }
  value.type = &types.resolve(type);
  return value;
}

void Expressions::checkLimits() const {
  constexpr std::size_t kNodesOfElement = 16;
  types.checkLimits();
  types.checkGrowth(system.nodes, kNodesOfElement);
}

/// Few elements are compared one by one, which other passes read well. Many are halved, so that no
/// expression is deep.
Value Expressions::elementAt(NodeId at, const Elements& elements, std::int64_t low,
                             std::int64_t high) {
  constexpr std::int64_t kFew = 64;
  if (high - low >= kFew) {
    const std::int64_t middle = low + (high - low) / 2;
    const NodeId isBelow = maker.binary(NodeOp::LessEqual, at, maker.number(middle));
    const Value below = elementAt(at, elements, low, middle);
    return choose(isBelow, below, elementAt(at, elements, middle + 1, high));
  }
  Value chosen = elements(high);
  for (std::int64_t i = high - 1; i >= low; --i) {
    checkLimits();
    chosen = choose(maker.equal(at, maker.number(i)), elements(i), chosen);
  }
  return chosen;
}

Value Expressions::index(const Expr& expr, const Scope& scope) {
  Value array = value(expr.operands.at(0), scope);
  if (array.type->kind != TypeKind::Array) unsupported("the indexed value is not an array");
  const Type& element = types.resolve(array.type->element.at(0));
  NodeId at = indexNode(expr, scope, array.type->size);
  const auto size = static_cast<std::ptrdiff_t>(types.scalars(element));
  const auto slice = [&](std::int64_t i) {
    auto begin = array.parts.begin() + i * size;
    return Value{&element, {begin, begin + size}};
  };
  if (auto constant = maker.constant(at)) return slice(*constant);
  auto bounds = valueBounds(system, at);
  Value chosen = elementAt(at, slice, bounds.low, bounds.high);
  if (bounds.low == bounds.high && mayFail(at)) // no conditional has checked it
    for (auto& part : chosen.parts)
      part = maker.require(maker.equal(at, maker.number(bounds.high)), part, system.nodes[at].c);
  return chosen;
}

namespace {

/// The position of a field within a record, and its type.
std::pair<std::size_t, const Type*> fieldOf(const Types& types, const Type& record,
                                            const std::string& name) {
  if (record.kind != TypeKind::Record) unsupported("`." + name + "`: the value is not a record");
  std::size_t offset = 0;
  for (const auto& member : record.members) {
    const Type& type = types.resolve(member.type.at(0));
    if (member.name == name) return {offset, &type};
    offset += types.scalars(type);
  }
  unsupported("no field is called `" + name + "`");
}

} // namespace

Value Expressions::field(const Expr& expr, const Scope& scope) {
  Value record = value(expr.operands.at(0), scope);
  auto [offset, type] = fieldOf(types, *record.type, expr.name);
  auto begin = record.parts.begin() + static_cast<std::ptrdiff_t>(offset);
  return {type, {begin, begin + static_cast<std::ptrdiff_t>(types.scalars(*type))}};
}

Value Expressions::literal(const Expr& expr, const Scope& scope, const Type* expected) {
  if (!expected) unsupported("the type of a composed value is not known");
  const Type& type = types.resolve(*expected);
  Value made{&type, {}};
  const std::string what = "a part of `" + fiacre::printExpr(expr) + "`";
  const auto append = [&](const Expr& part, const Type& partType) {
    const Value more = fitted(value(part, scope, &types.resolve(partType)), partType, what);
    made.parts.insert(made.parts.end(), more.parts.begin(), more.parts.end());
  };
  if (expr.kind == ExprKind::Array) {
    for (const auto& part : expr.operands) append(part, type.element.at(0));
  } else {
    for (const auto& member : type.members) {
      auto at = std::ranges::find(expr.fields, member.name);
      if (at == expr.fields.end()) unsupported("no value for the field `" + member.name + "`");
      append(expr.operands.at(static_cast<std::size_t>(at - expr.fields.begin())),
             member.type.at(0));
    }
  }
  if (made.parts.size() != types.scalars(type)) unsupported("a composed value of the wrong size");
  return made;
}

Value Expressions::lowest(const Type& type) {
  Value made{&types.resolve(type), {}};
  std::vector<const Type*> scalarTypes;
  types.flatten(type, scalarTypes);
  for (const auto* part : scalarTypes) {
    types.checkGrowth(made.parts, 1);
    auto bounds = types.bounds(*part);
    made.parts.push_back(maker.number(std::clamp<std::int64_t>(0, bounds.low, bounds.high)));
  }
  return made;
}

const Type& Expressions::typeOf(const Expr& lvalue, const Scope& scope) {
  return *target(lvalue, scope).type;
}

Expressions::Target Expressions::target(const Expr& lvalue, const Scope& scope) {
  if (lvalue.kind == ExprKind::Name) {
    auto found = scope.find(lvalue.name);
    if (found == scope.end()) unsupported("`" + lvalue.name + "` is not a variable");
    return {found->second.type, &found->second, {{maker.number(1), 0}}};
  }
  Target whole = target(lvalue.operands.at(0), scope);
  if (lvalue.kind == ExprKind::Field) {
    auto [offset, type] = fieldOf(types, *whole.type, lvalue.name);
    for (auto& place : whole.offsets) place.second += offset;
    whole.type = type;
    return whole;
  }
  if (lvalue.kind != ExprKind::Index || whole.type->kind != TypeKind::Array)
    unsupported("this cannot be assigned to");
  NodeId at = indexNode(lvalue, scope, whole.type->size);
  auto bounds = valueBounds(system, at);
  Target part{&types.resolve(whole.type->element.at(0)), whole.root, {}};
  const std::size_t size = types.scalars(*part.type);
  for (const auto& [condition, offset] : whole.offsets)
    for (std::int64_t i = bounds.low; i <= bounds.high; ++i) {
      checkLimits();
      types.checkGrowth(part.offsets, 1);
      part.offsets.emplace_back(maker.both(condition, maker.equal(at, maker.number(i))),
                                offset + size * static_cast<std::size_t>(i));
    }
  return part;
}

void Expressions::assign(const Expr& lvalue, const Value& source, const Scope& scope,
                         std::vector<Assignment>& assignments, std::size_t first) {
  Target place = target(lvalue, scope);
  const std::size_t size = types.scalars(*place.type);
  if (source.parts.size() != size) unsupported("a value of another type is assigned");
  Earlier earlier;
  for (std::size_t i = first; i < assignments.size(); ++i)
    earlier.emplace(assignments[i].target, i);
  for (const auto& [condition, offset] : place.offsets)
    for (std::size_t i = 0; i < size; ++i) {
      checkLimits();
      types.checkGrowth(assignments, 1);
      const NodeId old = place.root->parts.at(offset + i);
      if (system.nodes[old].op != NodeOp::Cell)
        unsupported("the target of the assignment is not a variable");
      write(system.nodes[old].a, old, condition, source.parts[i], assignments, earlier);
    }
}

/// Writes a cell if a condition is true. `a[i], a[j] := x, y` may write a cell twice; the last true
/// one wins.
void Expressions::write(CellId cell, NodeId old, NodeId condition, NodeId source,
                        std::vector<Assignment>& assignments, const Earlier& earlier) {
  const auto before = earlier.find(cell);
  const bool again = before != earlier.end();
  const NodeId made =
      maker.conditional(condition, source, again ? assignments[before->second].value : old);
  const auto bounds = valueBounds(system, made);
  const bool fits = system.cells[cell].low <= bounds.low && bounds.high <= system.cells[cell].high;
  if (again)
    assignments[before->second] = {cell, made, !fits};
  else
    assignments.push_back({cell, made, !fits});
}

} // namespace proskill::verify
