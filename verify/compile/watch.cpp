#include "verify/compile/watch.h"

#include "fiacre/syntax/parse.h"
#include "verify/unsupported.h"

#include <algorithm>
#include <cctype>

namespace proskill::verify {

using fiacre::Type;
using fiacre::TypeKind;

namespace {

/// Splits `skill[takeoff].status` into `skill`, `[takeoff`, `.status`.
std::vector<std::string> cut(const std::string& lvalue) {
  std::vector<std::string> parts(1);
  for (char c : lvalue) {
    if (c == '[' || c == '.') parts.emplace_back();
    if (c != ']' && c != ' ' && c != '(' && c != ')') parts.back() += c;
  }
  return parts;
}

std::vector<std::string> valueWords(const Type& type, const fiacre::Watched& watched) {
  std::vector<std::string> words;
  if (type.kind == TypeKind::Bool) words = {"false", "true"};
  if (type.kind == TypeKind::Union)
    for (const auto& member : type.members) words.push_back(member.name);
  for (auto& word : words)
    if (auto known = watched.values.find(word); known != watched.values.end()) word = known->second;
  return words;
}

/// Follows the parts of an lvalue from a component's variable to a cell.
class Finder {
public:
  Finder(const Elaboration& of, const Types& known, const System& in)
      : model(of), types(known), system(in) {}

  std::optional<WatchedCell> find(const fiacre::Watched& watched) const {
    auto parts = cut(watched.lvalue);
    auto root = model.componentScope.find(parts[0]);
    if (root == model.componentScope.end()) return std::nullopt;
    const Type* type = root->second.type;
    std::size_t offset = 0;
    for (std::size_t i = 1; i < parts.size(); ++i)
      if (!follow(parts[i], type, offset)) return std::nullopt;
    const auto& node = system.nodes[root->second.parts.at(offset)];
    if (types.scalars(*type) != 1 || node.op != NodeOp::Cell) return std::nullopt;
    return WatchedCell{watched.display, node.a, valueWords(*type, watched)};
  }

private:
  bool follow(const std::string& part, const Type*& type, std::size_t& offset) const {
    const std::string name = part.substr(1);
    if (part[0] == '.') {
      if (type->kind != TypeKind::Record) return false;
      for (const auto& member : type->members) {
        const Type& next = types.resolve(member.type.at(0));
        if (member.name == name) {
          type = &next;
          return true;
        }
        offset += types.scalars(next);
      }
      return false;
    }
    auto at = index(name);
    if (type->kind != TypeKind::Array || !at || *at < 0 || *at >= type->size) return false;
    type = &types.resolve(type->element.at(0));
    offset += static_cast<std::size_t>(*at) * types.scalars(*type);
    return true;
  }

  /// A number, or a constant of the model.
  [[nodiscard]] std::optional<std::int64_t> index(const std::string& name) const {
    bool digits = !name.empty() && name.size() < 10 && std::ranges::all_of(name, [](char c) {
      return std::isdigit(static_cast<unsigned char>(c)) != 0;
    });
    if (digits) return std::stoll(name);
    auto constant = model.constants.find(name);
    return constant == model.constants.end() ? std::nullopt : std::optional(constant->second);
  }

  const Elaboration& model;
  const Types& types;
  const System& system;
};

void watchStates(System& system) {
  for (const auto& instance : system.instances)
    if (instance.locations.size() > 1)
      system.watched.push_back({instance.name, instance.location, instance.locations});
}

/// Watches all variables of a model without provenance.
void watchAll(const Elaboration& model, System& system) {
  for (CellId i = 0; i < system.cells.size(); ++i)
    if (const Type* type = model.cellTypes[i])
      system.watched.push_back({system.cells[i].name, i, valueWords(*type, {})});
}

std::optional<NodeId> groundNode(const fiacre::Ground& ground, const Elaboration& model,
                                 Expressions& expressions) {
  const auto expr = fiacre::parseExpr(ground.expr);
  if (!expr) return std::nullopt;
  try {
    return expressions.scalar(*expr, model.componentScope);
  } catch (const CompileError&) {
    return std::nullopt;
  }
}

} // namespace

void watch(const fiacre::Provenance& provenance, const Elaboration& model, const Types& types,
           System& system) {
  if (provenance.byHand) watchStates(system);
  if (provenance.watched.empty()) return watchAll(model, system);
  Finder finder(model, types, system);
  for (const auto& watched : provenance.watched)
    if (auto found = finder.find(watched)) system.watched.push_back(std::move(*found));
}

std::string shown(const WatchedCell& watched, std::int64_t value) {
  if (value >= 0 && static_cast<std::size_t>(value) < watched.words.size())
    return watched.words[static_cast<std::size_t>(value)];
  return std::to_string(value);
}

void addGrounds(const fiacre::Provenance& provenance, const Elaboration& model,
                Expressions& expressions, System& system) {
  for (fiacre::OriginId origin = 0; origin < provenance.origins.size(); ++origin) {
    const auto& grounds = provenance.origins[origin].grounds;
    for (std::uint32_t i = 0; i < grounds.size(); ++i)
      if (const auto node = groundNode(grounds[i], model, expressions))
        system.grounds.push_back({origin, i, *node});
  }
}

} // namespace proskill::verify
