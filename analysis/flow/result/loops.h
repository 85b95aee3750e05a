#pragma once

#include "analysis/flow/engine/graph.h"

#include <functional>
#include <vector>

namespace proskill::analysis::flow {

/// Whether no time passes in a step from this node, whatever the others do.
[[nodiscard]] bool takesNoTime(const Node& node);

/// The loops of a graph that stay within some of its nodes: its strongly connected components that
/// have an edge inside, each with its nodes in their order.
[[nodiscard]] std::vector<std::vector<NodeId>> loopsOf(const Graph& graph,
                                                       const std::function<bool(NodeId)>& within);

} // namespace proskill::analysis::flow
