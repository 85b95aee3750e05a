#include "verify/compile/types.h"

#include "verify/unsupported.h"

#include <utility>

namespace proskill::verify {

using fiacre::Type;
using fiacre::TypeKind;

Types::Types(const fiacre::Program& program, LimitWatch* watch) : limits(watch) {
  for (const auto& type : program.types) declared.emplace(type.name, &type.type);
}

const Type& Types::resolve(const Type& type) const {
  const Type* current = &type;
  for (std::size_t hops = 0; current->kind == TypeKind::Named; ++hops) {
    auto found = declared.find(current->name);
    if (found == declared.end()) unsupported("the type `" + current->name + "` is not declared");
    if (hops > declared.size()) unsupported("the type `" + current->name + "` is itself");
    current = found->second;
  }
  return *current;
}

std::size_t Types::scalars(const Type& type) const {
  std::vector<const Type*> all;
  flatten(type, all);
  return all.size();
}

void Types::flatten(const Type& named, std::vector<const Type*>& all) const {
  checkLimits();
  checkGrowth(all, 1);
  const Type& type = resolve(named);
  switch (type.kind) {
  case TypeKind::Record:
    for (const auto& member : type.members) flatten(member.type.at(0), all);
    return;
  case TypeKind::Array:
    for (std::int64_t i = 0; i < type.size; ++i) flatten(type.element.at(0), all);
    return;
  case TypeKind::Queue: {
    auto [length, _] =
        lengths.try_emplace(type.size, Type{.kind = TypeKind::Range, .low = 0, .high = type.size});
    all.push_back(&length->second);
    for (std::int64_t i = 0; i < type.size; ++i) flatten(type.element.at(0), all);
    return;
  }
  case TypeKind::Union:
    all.push_back(&type);
    for (const auto& member : type.members)
      if (!member.type.empty()) flatten(member.type[0], all);
    return;
  case TypeKind::Bool:
  case TypeKind::Nat:
  case TypeKind::Int:
  case TypeKind::Range:
  case TypeKind::Named: break;
  }
  all.push_back(&type);
}

std::optional<std::int64_t> Types::constructor(const Type& named, std::string_view name) const {
  const Type& type = resolve(named);
  if (type.kind != TypeKind::Union) return std::nullopt;
  for (std::size_t i = 0; i < type.members.size(); ++i)
    if (type.members[i].name == name) return static_cast<std::int64_t>(i);
  return std::nullopt;
}

std::pair<std::size_t, const Type*> Types::payload(const Type& named, std::int64_t number) const {
  const Type& type = resolve(named);
  std::size_t offset = 1;
  for (std::int64_t i = 0; i < number; ++i)
    if (const auto& member = type.members[static_cast<std::size_t>(i)]; !member.type.empty())
      offset += scalars(member.type[0]);
  const auto& member = type.members.at(static_cast<std::size_t>(number));
  return {offset, member.type.empty() ? nullptr : &resolve(member.type[0])};
}

const Type* Types::unionWith(std::string_view name) const {
  const Type* found = nullptr;
  for (const auto& [_, type] : declared) {
    auto number = constructor(*type, name);
    if (!number) continue;
    if (found && constructor(*found, name) != number)
      unsupported("`" + std::string(name) + "` may be of several types");
    found = &resolve(*type);
  }
  return found;
}

Types::Bounds Types::bounds(const Type& scalar) const {
  constexpr std::int64_t kMost = (std::int64_t{1} << 30) - 1;
  const Type& type = resolve(scalar);
  switch (type.kind) {
  case TypeKind::Bool: return {0, 1};
  case TypeKind::Nat: return {0, kMost};
  case TypeKind::Int: return {-kMost - 1, kMost};
  case TypeKind::Range: return {type.low, type.high};
  case TypeKind::Union: return {0, static_cast<std::int64_t>(type.members.size()) - 1};
  case TypeKind::Record:
  case TypeKind::Array:
  case TypeKind::Queue:
  case TypeKind::Named: unsupported("expected one number, found a value with several parts");
  }
  std::unreachable();
}

} // namespace proskill::verify
