#include "fiacre/check/typing.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::fiacre {
namespace {

bool isStructure(const Type& type) {
  return type.kind == TypeKind::Record || type.kind == TypeKind::Union;
}

bool sameMembers(const Type& a, const Type& b, const Declarations& declarations) {
  return std::ranges::equal(a.members, b.members, [&](const Member& x, const Member& y) {
    return x.name == y.name && x.type.size() == y.type.size() &&
           (x.type.empty() || sameType(x.type[0], y.type[0], declarations));
  });
}

} // namespace

Type canonical(const Type& type, const Declarations& declarations) {
  auto found = type;
  // a type that contains itself is reported elsewhere; here the loop only has to end
  for (std::size_t depth = 0; depth <= declarations.types.size(); ++depth) {
    if (found.kind != TypeKind::Named) return found;
    const auto* declaration = lookUp(declarations.types, found.name);
    if (!declaration || isStructure((*declaration)->type)) return found;
    found = (*declaration)->type;
  }
  return found;
}

bool sameType(const Type& left, const Type& right, const Declarations& declarations) {
  const auto a = canonical(left, declarations);
  const auto b = canonical(right, declarations);
  if (a.kind != b.kind) return false;
  switch (a.kind) {
  case TypeKind::Bool:
  case TypeKind::Nat:
  case TypeKind::Int: return true;
  case TypeKind::Range: return a.low == b.low && a.high == b.high;
  case TypeKind::Named: return a.name == b.name;
  case TypeKind::Array:
  case TypeKind::Queue:
    return a.size == b.size && sameType(a.element[0], b.element[0], declarations);
  case TypeKind::Record:
  case TypeKind::Union: return sameMembers(a, b, declarations);
  }
  return false;
}

void checkType(const Type& type, const Declarations& declarations, const Report& report) {
  if (type.kind == TypeKind::Named && !lookUp(declarations.types, type.name))
    report(fmt::format("the type `{}` is not declared", type.name));
  if (type.kind == TypeKind::Range && type.low > type.high)
    report(fmt::format("the range {}..{} is empty", type.low, type.high));
  if ((type.kind == TypeKind::Array || type.kind == TypeKind::Queue) && type.size <= 0)
    report("an array or a queue must have a size of at least 1");
  if (isStructure(type)) {
    if (type.members.empty()) report("a record or a union has no members");
    Names names(report);
    for (const auto& member : type.members)
      names.add(member.name, type.kind == TypeKind::Record ? "the field" : "the constructor");
  }
  for (const auto& element : type.element) checkType(element, declarations, report);
  for (const auto& member : type.members)
    for (const auto& inner : member.type) checkType(inner, declarations, report);
}

} // namespace proskill::fiacre
