#pragma once

#include "analysis/flow/engine/system.h"

#include <functional>
#include <vector>

namespace proskill::analysis::flow {

/// Whether a step from this node takes no time, whatever other processes do. \pre it has a graph
[[nodiscard]] bool takesNoTime(const Process& process, NodeId id);

/// The loops of a graph, restricted to some nodes: the strongly connected components with an inner
/// edge, each with its nodes in order.
[[nodiscard]] std::vector<std::vector<NodeId>> loopsOf(const Graph& graph,
                                                       const std::function<bool(NodeId)>& within);

} // namespace proskill::analysis::flow
