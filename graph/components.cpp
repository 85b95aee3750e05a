#include "graph/components.h"

#include <algorithm>

namespace proskill::graph {

namespace {

/// Tarjan's algorithm with an explicit stack, since graphs are deep.
class Tarjan {
public:
  Tarjan(std::size_t nodes, const Successor& of)
      : component(nodes, kNoNode), number(nodes, kNoNode), low(nodes), successor(of) {}

  void visit(Node root) {
    if (number[root] != kNoNode) return;
    enter(root);
    while (!calls.empty()) {
      auto& [node, arc] = calls.back();
      const auto target = successor(node, arc++);
      if (target == kNoNode)
        leave(node);
      else if (number[target] == kNoNode)
        enter(target);
      else if (component[target] == kNoNode)
        low[node] = std::min(low[node], number[target]);
    }
  }

  std::vector<Node> component;

private:
  struct Call {
    Node node;
    std::size_t arc;
  };

  void enter(Node node) {
    number[node] = low[node] = count++;
    stack.push_back(node);
    calls.push_back({node, 0});
  }

  void leave(Node node) {
    calls.pop_back();
    if (low[node] == number[node])
      while (component[node] == kNoNode) {
        component[stack.back()] = node;
        stack.pop_back();
      }
    if (calls.empty()) return;
    auto& before = low[calls.back().node];
    before = std::min(before, low[node]);
  }

  std::vector<std::uint32_t> number;
  std::vector<std::uint32_t> low;
  const Successor& successor;
  std::vector<Node> stack;
  std::vector<Call> calls;
  std::uint32_t count = 0;
};

} // namespace

std::vector<Node> componentsOf(std::size_t nodes, const Successor& successor) {
  Tarjan search(nodes, successor);
  for (Node node = 0; node < nodes; ++node) search.visit(node);
  return std::move(search.component);
}

} // namespace proskill::graph
