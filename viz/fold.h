#pragma once

#include "viz/graph.h"

#include <set>

namespace proskill::viz {

/// A graph in which some clusters are drawn as single nodes.
struct Folded {
  Graph graph;
  /// For each cluster of the original graph: the node or cluster of `graph` that represents it;
  /// neither if it is inside of a folded cluster.
  struct Part {
    std::optional<std::size_t> node;
    std::optional<std::size_t> cluster;
  };
  std::vector<Part> parts;
};

/// Folds clusters. Equal edges between the same nodes are merged; edges within a folded cluster are
/// dropped.
[[nodiscard]] Folded fold(const Graph& graph, const std::set<std::size_t>& clusters);

/// The clusters to fold so that about `most` nodes remain, the largest first. None if the graph is
/// small enough or nothing more can be folded.
[[nodiscard]] std::set<std::size_t> clustersToFold(const Graph& graph, std::size_t most);

} // namespace proskill::viz
