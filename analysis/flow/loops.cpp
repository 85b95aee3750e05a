#include "analysis/flow/loops.h"

#include <algorithm>

namespace proskill::analysis::flow {

namespace {

/// Tarjan's search with a stack of its own: bodies may be long.
class Components {
public:
  Components(const Graph& graph, const std::function<bool(NodeId)>& within)
      : graph(graph),
        within(within),
        number(graph.nodes.size()),
        low(graph.nodes.size()),
        open(graph.nodes.size()) {}

  std::vector<std::vector<NodeId>> find() {
    for (NodeId node = 0; node < graph.nodes.size(); ++node)
      if (number[node] == 0 && within(node)) search(node);
    return std::move(loops);
  }

private:
  struct Frame {
    NodeId node;
    std::size_t edge = 0;
  };

  void search(NodeId root) {
    enter(root);
    while (!frames.empty()) {
      Frame& frame = frames.back();
      NodeId node = frame.node;
      const auto& edges = graph[node].edges;
      if (frame.edge == edges.size()) {
        leave(node);
        continue;
      }
      NodeId next = edges[frame.edge++].target;
      if (next == kNoNode || !within(next)) continue;
      if (number[next] == 0)
        enter(next);
      else if (open[next])
        low[node] = std::min(low[node], number[next]);
    }
  }

  void enter(NodeId node) {
    number[node] = low[node] = ++count;
    open[node] = true;
    stack.push_back(node);
    frames.push_back({node});
  }

  void leave(NodeId node) {
    frames.pop_back();
    if (!frames.empty()) low[frames.back().node] = std::min(low[frames.back().node], low[node]);
    if (low[node] != number[node]) return;
    auto first = std::ranges::find(stack, node);
    std::vector<NodeId> component(first, stack.end());
    stack.erase(first, stack.end());
    for (NodeId each : component) open[each] = false;
    if (component.size() > 1 || hasSelfLoop(node)) loops.push_back(std::move(component));
  }

  [[nodiscard]] bool hasSelfLoop(NodeId node) const {
    return std::ranges::any_of(graph[node].edges,
                               [node](const Edge& edge) { return edge.target == node; });
  }

  const Graph& graph;
  const std::function<bool(NodeId)>& within;
  std::vector<std::uint32_t> number;
  std::vector<std::uint32_t> low;
  std::vector<bool> open;
  std::vector<NodeId> stack;
  std::vector<Frame> frames;
  std::uint32_t count = 0;
  std::vector<std::vector<NodeId>> loops;
};

} // namespace

std::vector<std::vector<NodeId>> loopsOf(const Graph& graph,
                                         const std::function<bool(NodeId)>& within) {
  return Components(graph, within).find();
}

} // namespace proskill::analysis::flow
