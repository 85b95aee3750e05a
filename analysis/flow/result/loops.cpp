#include "analysis/flow/result/loops.h"

#include "graph/components.h"

#include <algorithm>

namespace proskill::analysis::flow {

namespace {

bool hasSelfLoop(const Graph& graph, NodeId node) {
  return std::ranges::count(graph[node].edges, node, &Edge::target) > 0;
}

} // namespace

std::vector<std::vector<NodeId>> loopsOf(const Graph& graph,
                                         const std::function<bool(NodeId)>& within) {
  auto inside = [&](NodeId node) { return node != kNoNode && within(node); };
  const auto components =
      graph::componentsOf(graph.nodes.size(), [&](NodeId node, std::size_t i) -> NodeId {
        const auto& edges = graph[node].edges;
        if (i == edges.size()) return graph::kNoNode;
        return inside(node) && inside(edges[i].target) ? edges[i].target : node;
      });
  std::vector<std::vector<NodeId>> members(graph.nodes.size());
  for (NodeId node = 0; node < components.size(); ++node)
    if (within(node)) members[components[node]].push_back(node);
  std::erase_if(members, [&](const std::vector<NodeId>& component) {
    return component.empty() || (component.size() == 1 && !hasSelfLoop(graph, component.front()));
  });
  return members;
}

} // namespace proskill::analysis::flow
