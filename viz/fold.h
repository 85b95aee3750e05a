#pragma once

#include "viz/graph.h"

#include <set>

namespace proskill::viz {

/// A graph some of whose clusters are drawn as one node each.
struct Folded {
  Graph graph;
  /// Of each cluster of the whole graph, the node or the cluster of `graph` that stands for it;
  /// neither where it is within one that is folded.
  struct Part {
    std::optional<std::size_t> node;
    std::optional<std::size_t> cluster;
  };
  std::vector<Part> parts;
};

/// Edges between the same nodes that say the same become one; those within a folded cluster go.
[[nodiscard]] Folded fold(const Graph& graph, const std::set<std::size_t>& clusters);

/// Which clusters to fold so that about `most` nodes remain: the largest first, none where the
/// graph is small enough or where nothing more can be folded.
[[nodiscard]] std::set<std::size_t> clustersToFold(const Graph& graph, std::size_t most);

} // namespace proskill::viz
