#include "analysis/flow/result/loops.h"

#include "graph/components.h"

#include <algorithm>
#include <utility>

namespace proskill::analysis::flow {

namespace {

bool hasSelfLoop(const Graph& graph, NodeId node) {
  return std::ranges::count(graph[node].edges, node, &Edge::target) > 0;
}

} // namespace

bool takesNoTime(const Process& process, NodeId id) {
  const Node& node = (*process.graph)[id];
  switch (node.kind) {
  case NodeKind::Interrupt:
  case NodeKind::Test:
  case NodeKind::Choose:
  case NodeKind::Set:
  case NodeKind::Step: return true;
  case NodeKind::Emit: return process.actions[id].conditions.empty();
  case NodeKind::Delay: {
    const auto& upper = node.statement->duration.upper;
    return upper && upper->numerator == 0;
  }
  case NodeKind::Start:
  case NodeKind::Refused:
  case NodeKind::Run:
  case NodeKind::Call:
  case NodeKind::Wait:
  case NodeKind::Fork:
  case NodeKind::Leave:
  case NodeKind::Outcome:
  case NodeKind::InvariantFailure:
  case NodeKind::Interrupted:
  case NodeKind::End: return false;
  }
  std::unreachable();
}

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
