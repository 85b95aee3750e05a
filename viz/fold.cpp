#include "viz/fold.h"

#include <algorithm>
#include <functional>
#include <tuple>

namespace proskill::viz {
namespace {

using ClusterSet = std::set<std::size_t>;

/// The outermost cluster in the set that contains this one; possibly itself.
std::optional<std::size_t> holder(const Graph& graph, const ClusterSet& folded,
                                  std::optional<std::size_t> cluster) {
  std::optional<std::size_t> found;
  for (; cluster; cluster = graph.clusters[*cluster].parent)
    if (folded.contains(*cluster)) found = cluster;
  return found;
}

std::string countWords(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " node" : " nodes");
}

/// By cluster: number of nodes in it, including nested clusters.
std::vector<std::size_t> sizes(const Graph& graph) {
  std::vector<std::size_t> counts(graph.clusters.size());
  for (const auto& node : graph.nodes)
    for (auto at = node.cluster; at; at = graph.clusters[*at].parent) ++counts[*at];
  return counts;
}

class Folding {
public:
  Folding(const Graph& all, const ClusterSet& chosen) : whole(all), folded(chosen) {
    result.graph = {whole.title, whole.note, whole.layout, {}, {}, {}};
    result.parts.resize(whole.clusters.size());
  }

  Folded make() {
    keepClusters();
    keepNodes();
    keepEdges();
    return std::move(result);
  }

private:
  void keepClusters() {
    for (std::size_t i = 0; i < whole.clusters.size(); ++i) {
      if (holder(whole, folded, i)) continue;
      result.parts[i].cluster = result.graph.clusters.size();
      result.graph.clusters.push_back(whole.clusters[i]);
      result.graph.clusters.back().parent = kept(whole.clusters[i].parent);
    }
  }

  [[nodiscard]] std::optional<std::size_t> kept(std::optional<std::size_t> cluster) const {
    return cluster ? result.parts[*cluster].cluster : std::nullopt;
  }

  /// Keeps nodes; the node of a cluster takes the place of its first node.
  void keepNodes() {
    const auto counts = sizes(whole);
    for (const auto& node : whole.nodes) {
      const auto within = holder(whole, folded, node.cluster);
      if (!within) {
        places.push_back(result.graph.nodes.size());
        result.graph.nodes.push_back(node);
        result.graph.nodes.back().cluster = kept(node.cluster);
        continue;
      }
      auto& part = result.parts[*within];
      if (!part.node) {
        const auto& cluster = whole.clusters[*within];
        part.node = result.graph.nodes.size();
        result.graph.nodes.push_back({NodeRole::Folded,
                                      cluster.label,
                                      {countWords(counts[*within])},
                                      cluster.source,
                                      kept(cluster.parent)});
      }
      places.push_back(*part.node);
    }
  }

  void keepEdges() {
    std::set<std::tuple<std::size_t, std::size_t, EdgeRole, std::string>> seen;
    for (const auto& edge : whole.edges) {
      const auto from = places[edge.from];
      const auto to = places[edge.to];
      const bool inside = from == to && edge.from != edge.to;
      const bool loopInside =
          from == to && result.graph.nodes[from].role == NodeRole::Folded && edge.from == edge.to;
      if (inside || loopInside || !seen.emplace(from, to, edge.role, edge.label).second) continue;
      result.graph.edges.push_back(edge);
      result.graph.edges.back().from = from;
      result.graph.edges.back().to = to;
    }
  }

  const Graph& whole;
  const ClusterSet& folded;
  Folded result;
  std::vector<std::size_t> places; ///< by node of the whole graph: its node in the result
};

} // namespace

Folded fold(const Graph& graph, const std::set<std::size_t>& clusters) {
  return Folding(graph, clusters).make();
}

std::set<std::size_t> clustersToFold(const Graph& graph, std::size_t most) {
  std::set<std::size_t> chosen;
  auto rest = graph.nodes.size();
  if (rest <= most) return chosen;
  const auto counts = sizes(graph);
  std::vector<std::size_t> order(graph.clusters.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return counts[i]; });
  for (const auto i : order) {
    if (rest <= most) break;
    if (counts[i] < 2 || holder(graph, chosen, i)) continue;
    chosen.insert(i);
    rest -= counts[i] - 1;
  }
  return chosen;
}

} // namespace proskill::viz
