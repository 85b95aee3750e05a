#include "verify/components.h"

#include "verify/system.h"

#include <algorithm>

namespace proskill::verify {

namespace {

/// With a stack of its own: graphs are deep.
class Tarjan {
public:
  using Successor = std::function<std::uint32_t(std::uint32_t, std::size_t)>;

  Tarjan(std::size_t nodes, const Successor& of)
      : component(nodes, kNone), number(nodes, kNone), low(nodes), successor(of) {}

  void visit(std::uint32_t root) {
    if (number[root] != kNone) return;
    enter(root);
    while (!calls.empty()) {
      auto& [node, arc] = calls.back();
      const auto target = successor(node, arc++);
      if (target == kNone)
        leave(node);
      else if (number[target] == kNone)
        enter(target);
      else if (component[target] == kNone)
        low[node] = std::min(low[node], number[target]);
    }
  }

  std::vector<std::uint32_t> component;

private:
  struct Call {
    std::uint32_t node;
    std::size_t arc;
  };

  void enter(std::uint32_t node) {
    number[node] = low[node] = count++;
    stack.push_back(node);
    calls.push_back({node, 0});
  }

  void leave(std::uint32_t node) {
    calls.pop_back();
    if (low[node] == number[node])
      while (component[node] == kNone) {
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
  std::vector<std::uint32_t> stack;
  std::vector<Call> calls;
  std::uint32_t count = 0;
};

} // namespace

std::vector<std::uint32_t>
componentsOf(std::size_t nodes,
             const std::function<std::uint32_t(std::uint32_t, std::size_t)>& successor) {
  Tarjan search(nodes, successor);
  for (std::uint32_t node = 0; node < nodes; ++node) search.visit(node);
  return std::move(search.component);
}

} // namespace proskill::verify
