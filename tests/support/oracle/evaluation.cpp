#include "tests/support/oracle/evaluation.h"

#include <algorithm>

namespace proskill::oracle {

using fiacre::Expr;
using fiacre::ExprKind;
using fiacre::Op;
using fiacre::Statement;
using fiacre::StatementKind;
using fiacre::Type;
using fiacre::TypeKind;

namespace {

Type plain(TypeKind kind) {
  Type type;
  type.kind = kind;
  return type;
}

const Type kBool = plain(TypeKind::Bool);
const Type kInt = plain(TypeKind::Int);

bool isScalar(const Type& type) {
  switch (type.kind) {
  case TypeKind::Bool:
  case TypeKind::Nat:
  case TypeKind::Int:
  case TypeKind::Range: return true;
  case TypeKind::Union:
    return std::ranges::all_of(type.members,
                               [](const auto& member) { return member.type.empty(); });
  default: return false;
  }
}

/// Offset and index of a field in a record.
std::pair<std::size_t, const Type*> fieldOf(const Interpreter& model, const Type& record,
                                            std::string_view name) {
  std::size_t offset = 0;
  for (const auto& member : record.members) {
    if (member.name == name) return {offset, &member.type.front()};
    offset += slotCount(model, member.type.front());
  }
  throw ModelError("no field " + std::string(name));
}

std::int64_t arithmetic(Op op, std::int64_t a, std::int64_t b) {
  switch (op) {
  case Op::Less: return a < b;
  case Op::LessEqual: return a <= b;
  case Op::Greater: return a > b;
  case Op::GreaterEqual: return a >= b;
  case Op::Add: return a + b;
  case Op::Subtract: return a - b;
  case Op::Multiply: return a * b;
  case Op::Divide:
    if (b == 0) throw ModelError("division by zero");
    return a / b;
  case Op::Modulo:
    if (b == 0) throw ModelError("division by zero");
    return a % b;
  default: throw ModelError("an operator that is not of numbers");
  }
}

} // namespace

std::size_t slotCount(const Interpreter& model, const Type& named) {
  const Type& type = resolveType(model, named);
  switch (type.kind) {
  case TypeKind::Record: {
    std::size_t sum = 0;
    for (const auto& member : type.members) sum += slotCount(model, member.type.front());
    return sum;
  }
  case TypeKind::Array:
    return static_cast<std::size_t>(type.size) * slotCount(model, type.element.front());
  case TypeKind::Queue:
    return 1 + static_cast<std::size_t>(type.size) * slotCount(model, type.element.front());
  case TypeKind::Union: {
    std::size_t widest = 0;
    for (const auto& member : type.members)
      if (!member.type.empty()) widest = std::max(widest, slotCount(model, member.type.front()));
    return 1 + widest;
  }
  default: return 1;
  }
}

Bounds boundsOf(const Interpreter& model, const Type& named) {
  const Type& type = resolveType(model, named);
  if (!isScalar(type)) throw ModelError("all values of a type that is no scalar");
  if (type.kind == TypeKind::Bool) return {0, 1};
  if (type.kind == TypeKind::Range) return {type.low, type.high};
  if (type.kind == TypeKind::Union) return {0, std::ssize(type.members) - 1};
  throw ModelError("all values of an unbounded type");
}

std::vector<Store> valuesOf(const Interpreter& model, const Type& named) {
  const Type& type = resolveType(model, named);
  std::vector<Store> all;
  const bool isUnion = type.kind == TypeKind::Union;
  const auto [low, high] =
      isUnion ? Bounds{0, std::ssize(type.members) - 1} : boundsOf(model, type);
  for (auto value = low; value <= high; ++value) {
    Store one(slotCount(model, type), 0);
    one[0] = value;
    const auto* member = isUnion ? &type.members[static_cast<std::size_t>(value)] : nullptr;
    if (!member || member->type.empty()) {
      all.push_back(one);
      continue;
    }
    for (const auto& inner : valuesOf(model, member->type.front())) {
      std::ranges::copy(inner, one.begin() + 1);
      all.push_back(one);
    }
  }
  return all;
}

Store defaultValue(const Interpreter& model, const Type& named) {
  const Type& type = resolveType(model, named);
  if (type.kind == TypeKind::Range) return {type.low};
  if (type.kind != TypeKind::Record && type.kind != TypeKind::Array)
    return Store(slotCount(model, type), 0);
  Store all;
  auto append = [&](const Type& part) {
    Store one = defaultValue(model, part);
    all.insert(all.end(), one.begin(), one.end());
  };
  for (const auto& member : type.members) append(member.type.front());
  for (std::int64_t i = 0; i < type.size; ++i) append(type.element.front());
  return all;
}

const Type& Evaluation::resolve(const Type& type) const { return resolveType(model, type); }

std::optional<std::int64_t> Evaluation::constructor(const Type& named,
                                                    std::string_view name) const {
  const Type& type = resolve(named);
  if (type.kind != TypeKind::Union) return std::nullopt;
  auto found = std::ranges::find(type.members, name, &fiacre::Member::name);
  if (found == type.members.end()) return std::nullopt;
  return found - type.members.begin();
}

const Type& Evaluation::unionOf(std::string_view name) const {
  const Type* found = nullptr;
  for (const auto& [_, declaration] : model.types) {
    if (!constructor(declaration->type, name)) continue;
    if (found) throw ModelError("which union has the constructor " + std::string(name) + "?");
    found = &declaration->type;
  }
  if (!found) throw ModelError("unknown name " + std::string(name));
  return *found;
}

std::int64_t Evaluation::name(const std::string& name, const Type* expected) {
  if (auto variable = scope.find(name); variable != scope.end())
    return store[variable->second.offset];
  if (expected)
    if (auto index = constructor(*expected, name)) return *index;
  if (auto constant = model.constants.find(name); constant != model.constants.end())
    return number(constant->second->value, &constant->second->type);
  return *constructor(unionOf(name), name);
}

std::optional<Place> Evaluation::place(const Expr& expr) {
  if (expr.kind == ExprKind::Name) {
    auto variable = scope.find(expr.name);
    if (variable == scope.end()) return std::nullopt;
    return variable->second;
  }
  if (expr.kind != ExprKind::Index && expr.kind != ExprKind::Field) return std::nullopt;
  auto whole = place(expr.operands[0]);
  if (!whole) return std::nullopt;
  const Type& type = resolve(*whole->type);
  if (expr.kind == ExprKind::Field) {
    auto [offset, part] = fieldOf(model, type, expr.name);
    return Place{whole->offset + offset, part};
  }
  auto index = number(expr.operands[1], &kInt);
  if (index < 0 || index >= type.size) throw ModelError("index out of range");
  const Type& element = type.element.front();
  return Place{whole->offset + static_cast<std::size_t>(index) * slotCount(model, element),
               &element};
}

const Type* Evaluation::typeOf(const Expr& expr) {
  switch (expr.kind) {
  case ExprKind::Bool: return &kBool;
  case ExprKind::Number: return &kInt;
  case ExprKind::Conditional: {
    const Type* type = typeOf(expr.operands[1]);
    return type ? type : typeOf(expr.operands[2]);
  }
  case ExprKind::Construct: {
    auto function = model.functions.find(expr.name);
    return function == model.functions.end() ? nullptr : &function->second->result;
  }
  case ExprKind::Unary:
    if (expr.op == Op::First || expr.op == Op::Dequeue) {
      const Type* queue = typeOf(expr.operands[0]);
      return !queue || expr.op == Op::Dequeue ? queue : &resolve(*queue).element.front();
    }
    return expr.op == Op::Negate || expr.op == Op::Coerce ? &kInt : &kBool;
  case ExprKind::Binary:
    if (expr.op == Op::Enqueue || expr.op == Op::Append) return typeOf(expr.operands[0]);
    return expr.op >= Op::Add ? &kInt : &kBool;
  default: break;
  }
  auto found = place(expr);
  return found ? found->type : nullptr;
}

bool Evaluation::equal(const Expr& left, const Expr& right) {
  const Type* type = typeOf(left);
  if (!type) type = typeOf(right);
  return value(left, type) == value(right, type);
}

std::int64_t Evaluation::unary(const Expr& expr) {
  const Expr& operand = expr.operands[0];
  switch (expr.op) {
  case Op::Not: return !truth(operand);
  case Op::Negate: return -number(operand);
  case Op::Coerce: return number(operand);
  case Op::Empty: return value(operand).front() == 0;
  case Op::Full: return value(operand).front() == resolve(*typeOf(operand)).size;
  default: throw ModelError("an operator that is not of one scalar");
  }
}

std::int64_t Evaluation::binary(const Expr& expr) {
  const auto& [left, right] = std::tie(expr.operands[0], expr.operands[1]);
  switch (expr.op) {
  case Op::And: return truth(left) && truth(right);
  case Op::Or: return truth(left) || truth(right);
  case Op::Equal: return equal(left, right);
  case Op::NotEqual: return !equal(left, right);
  default: return arithmetic(expr.op, number(left), number(right));
  }
}

std::int64_t Evaluation::number(const Expr& expr, const Type* expected) {
  switch (expr.kind) {
  case ExprKind::Bool:
  case ExprKind::Number: return expr.number;
  case ExprKind::Name: return name(expr.name, expected);
  case ExprKind::Unary: return expr.op == Op::First ? value(expr, expected).front() : unary(expr);
  case ExprKind::Binary: return binary(expr);
  case ExprKind::Conditional:
    return number(expr.operands[truth(expr.operands[0]) ? 1 : 2], expected);
  default: return value(expr, expected).front();
  }
}

Store Evaluation::value(const Expr& expr, const Type* expected) {
  if (auto found = place(expr)) {
    auto begin = store.begin() + static_cast<std::ptrdiff_t>(found->offset);
    return {begin, begin + static_cast<std::ptrdiff_t>(slotCount(model, *found->type))};
  }
  switch (expr.kind) {
  case ExprKind::Construct: return construct(expr, expected);
  case ExprKind::Conditional:
    return value(expr.operands[truth(expr.operands[0]) ? 1 : 2], expected);
  case ExprKind::Array:
  case ExprKind::Record: {
    if (!expected) throw ModelError("an array or a record without a type");
    const Type& type = resolve(*expected);
    Store all = defaultValue(model, type);
    std::size_t at = 0;
    for (std::size_t i = 0; i < expr.operands.size(); ++i) {
      const Type* part = expr.kind == ExprKind::Array ? &type.element.front() : nullptr;
      if (!part) std::tie(at, part) = fieldOf(model, type, expr.fields[i]);
      Store one = value(expr.operands[i], part);
      std::ranges::copy(one, all.begin() + static_cast<std::ptrdiff_t>(at));
      at += one.size();
    }
    return all;
  }
  case ExprKind::Queue: return queue(expr, expected);
  case ExprKind::Unary:
    if (expr.op == Op::First || expr.op == Op::Dequeue) return queue(expr, expected);
    break;
  case ExprKind::Binary:
    if (expr.op == Op::Enqueue || expr.op == Op::Append) return queue(expr, expected);
    break;
  case ExprKind::Name: {
    Store one(expected ? slotCount(model, *expected) : 1, 0);
    one[0] = name(expr.name, expected);
    return one;
  }
  default: break;
  }
  return {number(expr, expected)};
}

Store Evaluation::construct(const Expr& expr, const Type* expected) {
  if (auto function = model.functions.find(expr.name); function != model.functions.end())
    return call(*function->second, expr);
  const Type& type =
      resolve(expected && constructor(*expected, expr.name) ? *expected : unionOf(expr.name));
  auto index = constructor(type, expr.name);
  Store all(slotCount(model, type), 0);
  all[0] = *index;
  Store payload =
      value(expr.operands[0], &type.members[static_cast<std::size_t>(*index)].type.front());
  std::ranges::copy(payload, all.begin() + 1);
  return all;
}

Store Evaluation::queue(const Expr& expr, const Type* expected) {
  const Expr* whole = expr.kind == ExprKind::Queue ? nullptr : &expr.operands[0];
  const Type* named = whole && typeOf(*whole) ? typeOf(*whole) : expected;
  if (!named) throw ModelError("a queue without a type");
  const Type& type = resolve(*named);
  const Type& element = type.element.front();
  auto width = static_cast<std::ptrdiff_t>(slotCount(model, element));
  Store all = whole ? value(*whole, named) : defaultValue(model, type);
  auto insert = [&](const Expr& item, std::ptrdiff_t at) {
    if (all[0] == type.size) throw ModelError("a full queue");
    Store one = value(item, &element);
    all.insert(all.begin() + 1 + at * width, one.begin(), one.end());
    all.resize(slotCount(model, type));
    ++all[0];
  };
  if (!whole) {
    for (const auto& item : expr.operands) insert(item, all[0]);
  } else if (expr.kind == ExprKind::Binary) {
    insert(expr.operands[1], expr.op == Op::Enqueue ? all[0] : 0);
  } else {
    if (all[0] == 0) throw ModelError("an empty queue");
    if (expr.op == Op::First) return {all.begin() + 1, all.begin() + 1 + width};
    all.erase(all.begin() + 1, all.begin() + 1 + width);
    all.resize(slotCount(model, type), 0);
    --all[0];
  }
  return all;
}

std::string textOf(const Interpreter& model, Place scalar, const Store& store) {
  const Type& type = resolveType(model, *scalar.type);
  const std::int64_t value = store[scalar.offset];
  if (type.kind == TypeKind::Bool) return value ? "true" : "false";
  if (type.kind == TypeKind::Union) return type.members[static_cast<std::size_t>(value)].name;
  return std::to_string(value);
}

void Evaluation::assign(Place target, const Store& value) {
  const Type& type = resolve(*target.type);
  bool inside = type.kind == TypeKind::Range ? type.low <= value[0] && value[0] <= type.high
                : type.kind == TypeKind::Nat ? value[0] >= 0
                                             : true;
  if (!inside) throw ModelError("a value outside its type");
  std::ranges::copy(value, store.begin() + static_cast<std::ptrdiff_t>(target.offset));
}

bool Evaluation::matches(const Expr& pattern, const Store& value, const Type& named) {
  const Type& type = resolve(named);
  if (pattern.kind == ExprKind::Number || pattern.kind == ExprKind::Bool)
    return value[0] == pattern.number;
  auto index = constructor(type, pattern.name);
  if (pattern.kind == ExprKind::Construct) {
    if (!index) throw ModelError("a pattern of another type: " + pattern.name);
    if (value[0] != *index) return false;
    auto bound = place(pattern.operands[0]);
    if (bound) assign(*bound, {value.begin() + 1, value.end()});
    return bound || this->value(pattern.operands[0]).front() == value[1];
  }
  if (index) return value[0] == *index;
  auto constant = model.constants.find(pattern.name);
  if (constant != model.constants.end()) return value[0] == name(pattern.name, nullptr);
  if (pattern.name == "any" || pattern.name == "_") return true;
  throw ModelError("unknown pattern " + pattern.name);
}

} // namespace proskill::oracle
