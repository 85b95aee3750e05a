#include "report/picture_json.h"

#include "viz/dot/part_ids.h"
#include "viz/theme.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::report {

namespace {

/// A picture with more nodes takes Graphviz and readers too long, so parts of it are folded.
constexpr std::size_t kLargestUnfolded = 400;

std::set<std::size_t> clustersToFold(const viz::Graph& graph, const FoldKeys& keys) {
  if (!keys) return viz::clustersToFold(graph, kLargestUnfolded);
  std::set<std::size_t> chosen;
  for (std::size_t i = 0; i < graph.clusters.size(); ++i)
    if (std::ranges::count(*keys, viz::clusterId(i)) > 0) chosen.insert(i);
  return chosen;
}

/// An identifier, or null.
Json clusterOf(const std::optional<std::size_t>& cluster) {
  return cluster ? Json(viz::clusterId(*cluster)) : Json();
}

Json nodesJson(const viz::Graph& graph, const PlaceJson& place) {
  Json all = Json::array();
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const auto& node = graph.nodes[i];
    all.push_back({{"id", viz::nodeId(i)},
                   {"role", viz::nodeStyle(node.role, viz::Scheme::Light).id},
                   {"label", node.label},
                   {"details", node.details},
                   {"location", place(node.source)},
                   {"cluster", clusterOf(node.cluster)}});
  }
  return all;
}

Json edgesJson(const viz::Graph& graph, const PlaceJson& place) {
  Json all = Json::array();
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const auto& edge = graph.edges[i];
    all.push_back({{"id", viz::edgeId(i)},
                   {"from", viz::nodeId(edge.from)},
                   {"to", viz::nodeId(edge.to)},
                   {"role", viz::edgeStyle(edge.role, viz::Scheme::Light).id},
                   {"label", edge.label},
                   {"twoWay", edge.twoWay},
                   {"location", edge.source ? place(*edge.source) : Json()}});
  }
  return all;
}

Json clustersJson(const viz::Graph& graph, const PlaceJson& place) {
  Json all = Json::array();
  for (std::size_t i = 0; i < graph.clusters.size(); ++i) {
    const auto& cluster = graph.clusters[i];
    all.push_back({{"id", viz::clusterId(i)},
                   {"label", cluster.label},
                   {"parent", clusterOf(cluster.parent)},
                   {"location", place(cluster.source)}});
  }
  return all;
}

/// The parts that can be folded, and where they are now. Folding does not change their keys.
Json foldableJson(const DrawnPicture& picture) {
  Json all = Json::array();
  for (std::size_t i = 0; i < picture.folded.parts.size(); ++i) {
    const auto& part = picture.folded.parts[i];
    all.push_back({{"key", viz::clusterId(i)},
                   {"label", picture.whole.clusters[i].label},
                   {"part", part.node ? Json(viz::nodeId(*part.node)) : clusterOf(part.cluster)},
                   {"folded", part.node.has_value()}});
  }
  return all;
}

} // namespace

std::expected<DrawnPicture, std::string>
drawPicture(const analysis::Program& program, const viz::Request& request, const FoldKeys& fold) {
  auto whole = viz::draw(program, request);
  if (!whole) return std::unexpected(whole.error());
  const auto chosen = clustersToFold(*whole, fold);
  auto folded = viz::fold(*whole, chosen);
  return DrawnPicture{request, std::move(*whole), std::move(folded), !fold && !chosen.empty()};
}

Json pictureJson(const DrawnPicture& picture, const PlaceJson& place) {
  const auto& graph = picture.folded.graph;
  Json json{{"kind", viz::wordOf(picture.request.kind)},
            {"name", picture.request.name},
            {"title", picture.whole.title},
            {"note", picture.whole.note},
            {"nodes", nodesJson(graph, place)},
            {"edges", edgesJson(graph, place)},
            {"clusters", clustersJson(graph, place)},
            {"foldable", foldableJson(picture)}};
  if (picture.foldedForSize)
    json["foldedBecause"] =
        fmt::format("This picture has {} nodes: branches are folded. Double-click one to open it.",
                    picture.whole.nodes.size());
  return json;
}

Json picturesJson(const analysis::Program& program) {
  Json all = Json::array();
  for (const auto& request : viz::allPictures(program)) {
    const auto kind = viz::wordOf(request.kind);
    all.push_back({{"kind", kind},
                   {"name", request.name},
                   {"title", request.name.empty() ? std::string(kind) : request.name}});
  }
  return all;
}

} // namespace proskill::report
