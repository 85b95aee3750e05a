#include "cli/panel_json.h"

#include "cli/picture_kinds.h"
#include "cli/source_place.h"
#include "viz/fold.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace proskill::cli {

namespace {

using Json = nlohmann::ordered_json;

/// Beyond this many nodes a picture takes more than a moment to lay out, and more than a glance to
/// read.
constexpr std::size_t kLargestUnfolded = 400;

std::string keyOf(std::size_t cluster) { return fmt::format("cluster_{}", cluster); }

/// A picture whose parts are named as `toCGraph` names the groups of the SVG.
class PictureWriter {
public:
  PictureWriter(const analysis::Program& shown, const viz::Graph& drawn)
      : places(shown), whole(drawn) {
    for (std::size_t i = 0; i < shown.files.size(); ++i)
      files[shown.files[i].path.string()] = static_cast<syntax::FileId>(i);
  }

  Json nodes(const viz::Graph& graph) {
    Json all = Json::array();
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
      const auto& node = graph.nodes[i];
      all.push_back({{"id", fmt::format("n{}", i)},
                     {"role", viz::nodeStyle(node.role, viz::Scheme::Light).id},
                     {"label", node.label},
                     {"details", node.details},
                     {"location", place(node.source)},
                     {"cluster", node.cluster ? Json(keyOf(*node.cluster)) : Json()}});
    }
    return all;
  }

  Json edges(const viz::Graph& graph) {
    Json all = Json::array();
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
      const auto& edge = graph.edges[i];
      all.push_back({{"id", fmt::format("e{}", i)},
                     {"from", fmt::format("n{}", edge.from)},
                     {"to", fmt::format("n{}", edge.to)},
                     {"role", viz::edgeStyle(edge.role, viz::Scheme::Light).id},
                     {"label", edge.label},
                     {"location", edge.source ? place(*edge.source) : Json()}});
    }
    return all;
  }

  Json clusters(const viz::Graph& graph) {
    Json all = Json::array();
    for (std::size_t i = 0; i < graph.clusters.size(); ++i) {
      const auto& cluster = graph.clusters[i];
      all.push_back({{"id", keyOf(i)},
                     {"label", cluster.label},
                     {"parent", cluster.parent ? Json(keyOf(*cluster.parent)) : Json()},
                     {"location", place(cluster.source)}});
    }
    return all;
  }

  /// What can be folded, and where it is now. A key stays the same, whatever is folded.
  Json foldable(const viz::Folded& folded) {
    Json all = Json::array();
    for (std::size_t i = 0; i < folded.parts.size(); ++i) {
      const auto& part = folded.parts[i];
      const auto id = part.node      ? Json(fmt::format("n{}", *part.node))
                      : part.cluster ? Json(keyOf(*part.cluster))
                                     : Json();
      all.push_back({{"key", keyOf(i)},
                     {"label", whole.clusters[i].label},
                     {"part", id},
                     {"folded", part.node.has_value()}});
    }
    return all;
  }

private:
  Json place(const viz::Source& source) {
    const auto found = files.find(source.file);
    if (found == files.end()) return nullptr;
    const auto at = [&](syntax::Offset offset) {
      const auto it = places.at(found->second, offset);
      return Json{{"line", it.line}, {"column", it.column}};
    };
    return {{"file", places.path(found->second)},
            {"begin", at(source.range.begin)},
            {"end", at(source.range.end)}};
  }

  SourcePlaces places;
  const viz::Graph& whole;
  std::map<std::string, syntax::FileId> files;
};

std::set<std::size_t> chosenClusters(const viz::Graph& graph, const PictureParams& params) {
  if (!params.fold) return viz::clustersToFold(graph, kLargestUnfolded);
  std::set<std::size_t> chosen;
  for (std::size_t i = 0; i < graph.clusters.size(); ++i)
    if (std::ranges::count(*params.fold, keyOf(i)) > 0) chosen.insert(i);
  return chosen;
}

} // namespace

std::expected<PictureParams, std::string> readPictureParams(const Json& params) {
  PictureParams out;
  try {
    const auto kind = std::ranges::find(kPictureKinds, params.at("kind").get<std::string>(),
                                        &Choices<viz::Kind>::value_type::first);
    if (kind == kPictureKinds.end()) return std::unexpected("there are no pictures of this kind");
    out.request = {kind->second, params.at("name").get<std::string>(),
                   params.value("forbidden", false)};
    out.dark = params.value("dark", false);
    if (params.value("format", "svg") == "dot") out.format = viz::Format::Dot;
    if (params.contains("fold")) out.fold = params["fold"].get<std::vector<std::string>>();
  } catch (const Json::exception&) {
    return std::unexpected("these are no parameters of a picture");
  }
  return out;
}

Json paramsJson(const PictureParams& params) {
  Json json{{"kind", wordOf(kPictureKinds, params.request.kind)},
            {"name", params.request.name},
            {"dark", params.dark},
            {"forbidden", params.request.forbidden}};
  if (params.fold) json["fold"] = *params.fold;
  return json;
}

std::expected<Json, std::string> pictureJson(const analysis::Program& program,
                                             const PictureParams& params, bool errors) {
  const auto whole = viz::draw(program, params.request);
  if (!whole) return std::unexpected(whole.error());
  const auto chosen = chosenClusters(*whole, params);
  const auto folded = viz::fold(*whole, chosen);
  auto content = viz::render(folded.graph, params.format,
                             params.dark ? viz::Scheme::Dark : viz::Scheme::Light);
  if (!content) return std::unexpected(content.error());
  PictureWriter writer(program, *whole);
  Json json{{"kind", wordOf(kPictureKinds, params.request.kind)},
            {"name", params.request.name},
            {"title", whole->title},
            {"note", whole->note},
            {"content", std::move(*content)},
            {"errors", errors},
            {"nodes", writer.nodes(folded.graph)},
            {"edges", writer.edges(folded.graph)},
            {"clusters", writer.clusters(folded.graph)},
            {"foldable", writer.foldable(folded)}};
  if (!params.fold && !chosen.empty())
    json["foldedBecause"] =
        fmt::format("This picture has {} nodes: branches are folded. Double-click one to open it.",
                    whole->nodes.size());
  return json;
}

Json picturesJson(const analysis::Program& program) {
  Json all = Json::array();
  for (const auto& request : viz::allPictures(program)) {
    const auto& kind = wordOf(kPictureKinds, request.kind);
    all.push_back({{"kind", kind},
                   {"name", request.name},
                   {"title", request.name.empty() ? "calls" : request.name}});
  }
  return all;
}

Json filesJson(const analysis::Program& program) {
  Json all = Json::array();
  for (const auto& file : program.files)
    all.push_back(
        {{"uri", file.path.generic_string()}, {"label", file.path.filename().generic_string()}});
  return all;
}

} // namespace proskill::cli
