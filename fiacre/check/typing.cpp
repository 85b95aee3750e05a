#include "fiacre/check/typing.h"

#include "fiacre/print/print.h"
#include "fiacre/syntax/arithmetic.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

namespace proskill::fiacre {
namespace {

const Type kBool{};
const Type kInt{.kind = TypeKind::Int};

bool isNumber(const Type& type) {
  return type.kind == TypeKind::Nat || type.kind == TypeKind::Int || type.kind == TypeKind::Range;
}

} // namespace

const Type& Typing::structure(const Type& type) const {
  if (type.kind != TypeKind::Named) return type;
  const auto* declaration = lookUp(declarations->types, type.name);
  return declaration ? (*declaration)->type : type;
}

std::optional<std::int64_t> Typing::constant(const Expr& expr) const {
  if (expr.kind == ExprKind::Number) return expr.number;
  if (expr.kind == ExprKind::Name && !scope->contains(expr.name)) {
    const auto* found = lookUp(declarations->constants, expr.name);
    return found && (*found)->value.kind == ExprKind::Number ? std::optional((*found)->value.number)
                                                             : std::nullopt;
  }
  if (expr.kind == ExprKind::Unary && expr.op == Op::Negate) {
    const auto value = constant(expr.operands[0]);
    return value ? compute(Op::Subtract, 0, *value) : std::nullopt;
  }
  if (expr.kind != ExprKind::Binary) return std::nullopt;
  const auto left = constant(expr.operands[0]);
  const auto right = constant(expr.operands[1]);
  return left && right ? compute(expr.op, *left, *right) : std::nullopt;
}

void Typing::expectInRange(const Expr& expr, const Type& type) const {
  const auto value = constant(expr);
  if (!value) return;
  const bool fits = type.kind == TypeKind::Range ? type.low <= *value && *value <= type.high
                                                 : type.kind != TypeKind::Nat || *value >= 0;
  if (!fits)
    report(fmt::format("{} is outside of {}: `{}`", *value, printType(type), printExpr(expr)));
}

void Typing::expectRecord(const Expr& expr, const Type& type) const {
  const auto& members = structure(type).members;
  for (std::size_t i = 0; i < expr.operands.size(); ++i) {
    const auto member = std::ranges::find(members, expr.fields[i], &Member::name);
    if (member == members.end())
      report(fmt::format("{} has no field `{}`", printType(type), expr.fields[i]));
    else
      expect(expr.operands[i], member->type[0]);
  }
  for (const auto& member : members)
    if (std::ranges::count(expr.fields, member.name) != 1)
      report(
          fmt::format("`{}` must give the field `{}` exactly once", printExpr(expr), member.name));
}

/// Checks the parts of a literal of a structured type, since errors there are more precise.
bool Typing::expectParts(const Expr& expr, const Type& type) const {
  if (expr.kind == ExprKind::Conditional) {
    expectBool(expr.operands[0]);
    expect(expr.operands[1], type);
    expect(expr.operands[2], type);
    return true;
  }
  if (expr.kind == ExprKind::Record && structure(type).kind == TypeKind::Record) {
    expectRecord(expr, type);
    return true;
  }
  const bool array = expr.kind == ExprKind::Array && type.kind == TypeKind::Array;
  const bool queue = expr.kind == ExprKind::Queue && type.kind == TypeKind::Queue;
  if (!array && !queue) return false;
  const auto count = static_cast<std::int64_t>(expr.operands.size());
  if (array ? count != type.size : count > type.size)
    report(fmt::format("{} elements where {} is expected: `{}`", count, printType(type),
                       printExpr(expr)));
  for (const auto& operand : expr.operands) expect(operand, type.element[0]);
  return true;
}

void Typing::expect(const Expr& expr, const Type& wanted) const {
  if (isWild(expr)) return;
  const auto type = canonical(wanted, *declarations);
  if (expectParts(expr, type)) return;
  const auto found = infer(expr);
  if (!found) return;
  if (isNumber(type) && isNumber(*found)) return expectInRange(expr, type);
  if (!sameType(*found, type, *declarations))
    report(fmt::format("`{}` is of the type {}, not {}", printExpr(expr), printType(*found),
                       printType(wanted)));
}

void Typing::expectAll(const std::vector<Expr>& exprs, const std::vector<Type>& types,
                       std::string_view what) const {
  if (exprs.size() != types.size())
    return report(fmt::format("{} takes {} values, not {}", what, types.size(), exprs.size()));
  for (std::size_t i = 0; i < exprs.size(); ++i) expect(exprs[i], types[i]);
}

std::optional<Type> Typing::target(const Expr& lvalue) const {
  const auto* root = &lvalue;
  while (root->kind == ExprKind::Index || root->kind == ExprKind::Field) root = &root->operands[0];
  const auto* symbol = root->kind == ExprKind::Name ? lookUp(*scope, root->name) : nullptr;
  if (!symbol) {
    report(fmt::format("`{}` is not a variable and cannot be assigned to", printExpr(lvalue)));
    return std::nullopt;
  }
  if (!symbol->writable)
    report(fmt::format("`{}` is a parameter by value, and cannot be assigned to", root->name));
  return infer(lvalue);
}

std::optional<Type> Typing::infer(const Expr& expr) const {
  switch (expr.kind) {
  case ExprKind::Bool: return kBool;
  case ExprKind::Number: return kInt;
  case ExprKind::Name: return inferName(expr);
  case ExprKind::Construct: return inferConstruct(expr);
  case ExprKind::Unary: return inferUnary(expr);
  case ExprKind::Binary: return inferBinary(expr);
  case ExprKind::Index: return inferIndex(expr);
  case ExprKind::Field: return inferField(expr);
  case ExprKind::Array: return inferArray(expr);
  case ExprKind::Record: return inferRecord(expr);
  case ExprKind::Queue: return inferQueue(expr);
  case ExprKind::Conditional: break;
  }
  expectBool(expr.operands[0]);
  auto type = infer(expr.operands[1]);
  if (type) expect(expr.operands[2], isNumber(*type) ? kInt : *type);
  return type;
}

std::optional<Type> Typing::inferName(const Expr& expr) const {
  if (const auto* symbol = lookUp(*scope, expr.name)) return canonical(symbol->type, *declarations);
  if (const auto* found = lookUp(declarations->constants, expr.name))
    return canonical((*found)->type, *declarations);
  if (const auto* made = lookUp(declarations->constructors, expr.name)) {
    if (!made->member->type.empty())
      report(fmt::format("the constructor `{}` needs a value", expr.name));
    return Type{.kind = TypeKind::Named, .name = made->type->name};
  }
  report(fmt::format("`{}` is not declared", expr.name));
  return std::nullopt;
}

std::optional<Type> Typing::inferConstruct(const Expr& expr) const {
  const auto what = fmt::format("`{}`", expr.name);
  if (const auto* function = lookUp(declarations->functions, expr.name)) {
    std::vector<Type> types;
    for (const auto& parameter : (*function)->parameters) types.push_back(parameter.type);
    expectAll(expr.operands, types, what);
    return canonical((*function)->result, *declarations);
  }
  if (const auto* external = lookUp(declarations->externs, expr.name)) {
    expectAll(expr.operands, (*external)->parameters, what);
    return canonical((*external)->result, *declarations);
  }
  if (const auto* made = lookUp(declarations->constructors, expr.name)) {
    expectAll(expr.operands, made->member->type, what);
    return Type{.kind = TypeKind::Named, .name = made->type->name};
  }
  report(fmt::format("{} is neither a function nor a constructor", what));
  return std::nullopt;
}

void Typing::expectNumber(const Expr& expr) const {
  const auto type = infer(expr);
  if (type && !isNumber(*type))
    report(fmt::format("`{}` is of the type {}, not a number", printExpr(expr), printType(*type)));
}

std::optional<Type> Typing::queueOf(const Expr& expr) const {
  auto type = infer(expr);
  if (!type || type->kind == TypeKind::Queue) return type;
  report(fmt::format("`{}` is of the type {}, not a queue", printExpr(expr), printType(*type)));
  return std::nullopt;
}

std::optional<Type> Typing::inferUnary(const Expr& expr) const {
  const auto& operand = expr.operands[0];
  switch (expr.op) {
  case Op::Not: expectBool(operand); return kBool;
  case Op::Negate:
  case Op::Coerce: expectNumber(operand); return kInt;
  case Op::Empty:
  case Op::Full: (void)queueOf(operand); return kBool;
  case Op::First: {
    const auto queue = queueOf(operand);
    return queue ? std::optional(canonical(queue->element[0], *declarations)) : std::nullopt;
  }
  case Op::Dequeue: return queueOf(operand);
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
  case Op::Append: break;
  }
  std::unreachable();
}

void Typing::expectEqualTypes(const Expr& expr) const {
  const auto left = infer(expr.operands[0]);
  if (left) expect(expr.operands[1], isNumber(*left) ? kInt : *left);
}

std::optional<Type> Typing::inferBinary(const Expr& expr) const {
  const auto& operands = expr.operands;
  switch (expr.op) {
  case Op::And:
  case Op::Or:
    for (const auto& operand : operands) expectBool(operand);
    return kBool;
  case Op::Equal:
  case Op::NotEqual: expectEqualTypes(expr); return kBool;
  case Op::Enqueue:
  case Op::Append: {
    auto queue = queueOf(operands[0]);
    if (queue) expect(operands[1], queue->element[0]);
    return queue;
  }
  case Op::Not:
  case Op::Negate:
  case Op::Coerce:
  case Op::Empty:
  case Op::Full:
  case Op::First:
  case Op::Dequeue:
  case Op::Less:
  case Op::LessEqual:
  case Op::Greater:
  case Op::GreaterEqual:
  case Op::Add:
  case Op::Subtract:
  case Op::Multiply:
  case Op::Divide:
  case Op::Modulo: break;
  }
  for (const auto& operand : operands) expectNumber(operand);
  if ((expr.op == Op::Divide || expr.op == Op::Modulo) && constant(operands[1]) == 0)
    report(fmt::format("`{}` divides by 0", printExpr(expr)));
  const bool ordering = expr.op == Op::Less || expr.op == Op::LessEqual || expr.op == Op::Greater ||
                        expr.op == Op::GreaterEqual;
  return ordering ? kBool : kInt;
}

std::optional<Type> Typing::inferIndex(const Expr& expr) const {
  const auto array = infer(expr.operands[0]);
  if (!array) return std::nullopt;
  if (array->kind != TypeKind::Array) {
    report(fmt::format("`{}` is not an array", printExpr(expr.operands[0])));
    return std::nullopt;
  }
  expect(expr.operands[1], {.kind = TypeKind::Range, .low = 0, .high = array->size - 1});
  return canonical(array->element[0], *declarations);
}

std::optional<Type> Typing::inferField(const Expr& expr) const {
  const auto record = infer(expr.operands[0]);
  if (!record) return std::nullopt;
  const auto& members = structure(*record).members;
  const auto member = std::ranges::find(members, expr.name, &Member::name);
  if (structure(*record).kind != TypeKind::Record || member == members.end()) {
    report(fmt::format("`{}` has no field `{}`", printExpr(expr.operands[0]), expr.name));
    return std::nullopt;
  }
  return canonical(member->type[0], *declarations);
}

std::optional<Type> Typing::inferArray(const Expr& expr) const {
  if (expr.operands.empty()) return report("an array has no elements"), std::nullopt;
  const auto first = infer(expr.operands[0]);
  if (!first) return std::nullopt;
  for (const auto& operand : std::span(expr.operands).subspan(1)) expect(operand, *first);
  return Type{.kind = TypeKind::Array,
              .size = static_cast<std::int64_t>(expr.operands.size()),
              .element = {*first}};
}

/// If no type is expected, a record has the type with its fields.
std::optional<Type> Typing::inferRecord(const Expr& expr) const {
  for (const auto& [name, declaration] : declarations->types) {
    const auto& type = declaration->type;
    const bool fits = type.kind == TypeKind::Record &&
                      std::ranges::is_permutation(type.members, expr.fields, {}, &Member::name);
    if (!fits) continue;
    Type found{.kind = TypeKind::Named, .name = std::string(name)};
    expectRecord(expr, found);
    return found;
  }
  report(fmt::format("no record has the fields of `{}`", printExpr(expr)));
  return std::nullopt;
}

std::optional<Type> Typing::inferQueue(const Expr& expr) const {
  if (expr.operands.empty()) return report("the type of `{||}` is not known here"), std::nullopt;
  auto type = inferArray(expr);
  if (type) type->kind = TypeKind::Queue;
  return type;
}

} // namespace proskill::fiacre
