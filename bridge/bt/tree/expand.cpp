#include "bridge/bt/tree/expand.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::bridge::bt {
namespace {

/// The blackboard of one use of a tree: where its entries really are.
struct Scope {
  std::string prefix; ///< of private entries
  std::map<std::string, std::string> remapped;
  const Scope* outer = nullptr;
  bool automatic = false; ///< entries have the same names outside
};

/// The value of a port, where `{=}` is the entry with the name of the port.
std::string spelledOut(const std::string& port, const std::string& value) {
  return value == "{=}" ? "{" + port + "}" : value;
}

/// \param literally a port that got a value is that value
std::string resolve(const std::string& value, const Scope& scope, bool literally = false) {
  if (!isEntry(value)) return value;
  const auto start = value.find('{') + 1;
  auto key = value.substr(start, value.size() - start - 1);
  if (key.starts_with('@')) return value; // of the root's blackboard
  // The entry of a port that got a value may be overwritten: elsewhere it is one of the subtree.
  const auto found = scope.remapped.find(key);
  if (found != scope.remapped.end() && (literally || isEntry(found->second))) return found->second;
  const bool isPrivate = key.starts_with('_');
  if (found == scope.remapped.end() && scope.automatic && !isPrivate && scope.outer != nullptr)
    return resolve(value, *scope.outer, literally);
  return "{" + scope.prefix + key + "}";
}

class Expander {
public:
  Expander(const Forest& forest, Errors& errors) : forest(forest), errors(errors) {}

  Node tree(const std::string& id, const Scope& scope, std::size_t depth) {
    open.push_back(id);
    auto node = copy(forest.trees.at(id).root, scope, depth);
    open.pop_back();
    return node;
  }

private:
  Node copy(const Node& node, const Scope& scope, std::size_t depth) {
    Node result{node.kind, node.id, node.name, node.place, {}, {}};
    if (++count > kMostNodes || depth > kDeepestTree) return tooLarge(std::move(result));
    const bool isLeaf = node.kind == Kind::Action || node.kind == Kind::Condition;
    for (const auto& [key, value] : node.ports)
      result.ports.emplace(key, resolve(spelledOut(key, value), scope, isLeaf));
    if (node.kind == Kind::SubTree) return use(std::move(result), node, scope, depth);
    for (const auto& child : node.children)
      result.children.push_back(copy(child, scope, depth + 1));
    return result;
  }

  Node use(Node result, const Node& node, const Scope& scope, std::size_t depth) {
    if (!forest.trees.contains(node.id)) {
      fail(node,
           fmt::format("there is no tree `{}`; if it is in another file, `include` that", node.id));
    } else if (std::ranges::find(open, node.id) != open.end()) {
      fail(node, fmt::format("the tree `{}` contains itself", node.id));
    } else {
      const auto inner = scopeOf(node, scope);
      result.children.push_back(tree(node.id, inner, depth + 1));
    }
    return result;
  }

  Scope scopeOf(const Node& node, const Scope& outer) {
    if (isTrue(node.port("_shared_blackboard"))) return outer;
    Scope scope{.prefix = fmt::format("{}{}.{}/", outer.prefix, node.id, ++uses),
                .outer = &outer,
                .automatic = isTrue(node.port("_autoremap"))};
    for (const auto& [key, value] : node.ports)
      if (!key.starts_with('_'))
        scope.remapped.emplace(key, resolve(spelledOut(key, value), outer));
    return scope;
  }

  Node tooLarge(Node node) {
    if (!reported) fail(node, "the tree with all subtrees is too large");
    reported = true;
    return node;
  }

  void fail(const Node& node, std::string message) {
    errors.push_back({node.place, std::move(message)});
  }

  const Forest& forest;
  Errors& errors;
  std::vector<std::string> open;
  std::size_t count = 0;
  std::size_t uses = 0;
  bool reported = false;
};

} // namespace

std::expected<Node, Errors> expand(const Forest& forest) {
  Errors errors;
  Expander expander(forest, errors);
  auto node = expander.tree(forest.main, Scope{}, 0);
  if (!errors.empty()) return std::unexpected(std::move(errors));
  return node;
}

} // namespace proskill::bridge::bt
