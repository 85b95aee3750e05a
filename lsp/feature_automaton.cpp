#include "lsp/convert.h"
#include "lsp/verdict_json.h"
#include "viz/fold.h"
#include "viz/pictures.h"
#include "viz/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

/// `proskill/automaton`: pictures, and which part of them is which place of the program.
namespace proskill::lsp {

namespace {

constexpr std::array kKinds{
    std::pair{"sv", viz::Kind::StateVariable}, std::pair{"skill", viz::Kind::Skill},
    std::pair{"body", viz::Kind::Body}, std::pair{"calls", viz::Kind::Calls}};

std::string_view nameOf(viz::Kind kind) {
  return std::ranges::find(kKinds, kind, [](const auto& pair) { return pair.second; })->first;
}

std::string_view nameOf(viz::EdgeRole role) { return viz::edgeStyle(role, viz::Scheme::Light).id; }

std::string_view nameOf(viz::NodeRole role) { return viz::nodeStyle(role, viz::Scheme::Light).id; }

RpcError invalid(std::string message) { return {ErrorCode::InvalidParams, std::move(message)}; }

/// The picture of a definition; of what has none, the calls.
viz::Request pictureOf(const syntax::Form& form) {
  using viz::Kind;
  if (const auto* variable = std::get_if<syntax::StateVariable>(&form.node))
    return {Kind::StateVariable, std::string(variable->name.text), false};
  if (const auto* skill = std::get_if<syntax::Skill>(&form.node))
    return {skill->isComposite() ? Kind::Body : Kind::Skill, std::string(skill->name.text), false};
  if (const auto* environment = std::get_if<syntax::Environment>(&form.node))
    return {Kind::Body, std::string(environment->name.text), false};
  return {};
}

viz::Request pictureAt(const ide::View& view, syntax::Offset at) {
  for (const auto& form : view.document().forms())
    if (form.range.begin <= at && at <= form.range.end) return pictureOf(form);
  return {};
}

/// What is called so in the program, whatever it is.
std::expected<viz::Request, RpcError> pictureOf(const analysis::Program& program,
                                                const std::string& name) {
  for (const auto& file : program.files)
    for (const auto& form : file.document.forms())
      if (auto picture = pictureOf(form); picture.name == name) return picture;
  return std::unexpected(RpcError{ErrorCode::RequestFailed, "nothing is called `" + name + "`"});
}

std::expected<viz::Request, RpcError> pictureNamed(const analysis::Program& program,
                                                   const Json& params) {
  auto kind = params.value("kind", Json());
  auto name = params.value("name", Json(""));
  if (kind.is_null() && name.is_string() && !name.get_ref<const std::string&>().empty())
    return pictureOf(program, name.get_ref<const std::string&>());
  const auto* known =
      std::ranges::find_if(kKinds, [&](const auto& it) { return kind == it.first; });
  if (known == kKinds.end()) return std::unexpected(invalid("`kind` is sv, skill, body or calls"));
  if (!name.is_string()) return std::unexpected(invalid("`name` is no string"));
  return viz::Request{known->second, name.get<std::string>(), false};
}

/// Makes the lists of a picture's parts, with their places.
class Parts {
public:
  Parts(const viz::Graph& of, const analysis::Program& in, const Converter& with)
      : graph(of), program(in), convert(with) {}

  [[nodiscard]] Json nodes() const {
    Json all = Json::array();
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
      const auto& node = graph.nodes[i];
      all.push_back({{"id", nodeId(i)},
                     {"role", nameOf(node.role)},
                     {"label", node.label},
                     {"details", node.details},
                     {"location", location(node.source)},
                     {"cluster", node.cluster ? Json(clusterId(*node.cluster)) : Json()}});
    }
    return all;
  }

  [[nodiscard]] Json edges() const {
    Json all = Json::array();
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
      const auto& edge = graph.edges[i];
      all.push_back({{"id", edgeId(i)},
                     {"from", nodeId(edge.from)},
                     {"to", nodeId(edge.to)},
                     {"role", nameOf(edge.role)},
                     {"label", edge.label},
                     {"twoWay", edge.twoWay},
                     {"location", edge.source ? location(*edge.source) : Json()}});
    }
    return all;
  }

  [[nodiscard]] Json clusters() const {
    Json all = Json::array();
    for (std::size_t i = 0; i < graph.clusters.size(); ++i) {
      const auto& cluster = graph.clusters[i];
      all.push_back({{"id", clusterId(i)},
                     {"label", cluster.label},
                     {"parent", cluster.parent ? Json(clusterId(*cluster.parent)) : Json()},
                     {"location", location(cluster.source)}});
    }
    return all;
  }

  /// The part with the smallest range around a place: nodes go before edges, these before clusters.
  [[nodiscard]] Json at(analysis::FileId file, syntax::Offset offset) const {
    Json best;
    syntax::Offset length = 0;
    auto offer = [&](const viz::Source& source, const std::string& id) {
      const bool holds = source.file == program.files[file].path.string() &&
                         source.range.begin <= offset && offset <= source.range.end &&
                         source.range.length() > 0;
      if (!holds || (!best.is_null() && source.range.length() >= length)) return;
      best = id;
      length = source.range.length();
    };
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) offer(graph.nodes[i].source, nodeId(i));
    if (!best.is_null()) return best;
    for (std::size_t i = 0; i < graph.edges.size(); ++i)
      if (graph.edges[i].source) offer(*graph.edges[i].source, edgeId(i));
    if (!best.is_null()) return best;
    for (std::size_t i = 0; i < graph.clusters.size(); ++i)
      offer(graph.clusters[i].source, clusterId(i));
    return best;
  }

  // As viz/dot.cpp names the groups of the SVG.
  static std::string nodeId(std::size_t i) { return fmt::format("n{}", i); }
  static std::string edgeId(std::size_t i) { return fmt::format("e{}", i); }
  static std::string clusterId(std::size_t i) { return fmt::format("cluster_{}", i); }

private:
  [[nodiscard]] Json location(const viz::Source& source) const {
    for (analysis::FileId i = 0; i < program.files.size(); ++i)
      if (program.files[i].path.string() == source.file) return convert.location({i, source.range});
    return nullptr;
  }

  const viz::Graph& graph;
  const analysis::Program& program;
  const Converter& convert;
};

/// What can be folded, and where it is in the picture. A key stays the same, whatever is folded.
Json foldableJson(const viz::Graph& whole, const viz::Folded& folded) {
  Json all = Json::array();
  for (std::size_t i = 0; i < folded.parts.size(); ++i) {
    const auto& part = folded.parts[i];
    const auto id = part.node      ? Json(Parts::nodeId(*part.node))
                    : part.cluster ? Json(Parts::clusterId(*part.cluster))
                                   : Json();
    all.push_back({{"key", Parts::clusterId(i)},
                   {"label", whole.clusters[i].label},
                   {"part", id},
                   {"folded", part.node.has_value()}});
  }
  return all;
}

/// Beyond this many nodes a picture takes more than a moment to lay out, and more than a glance to
/// read.
constexpr std::size_t kLargestUnfolded = 400;

/// The clusters that are asked for; where nothing is said, as is best for the size of the picture.
std::set<std::size_t> clustersToFold(const viz::Graph& graph, const Json& params) {
  const auto asked = params.value("fold", Json());
  if (!asked.is_array()) return viz::clustersToFold(graph, kLargestUnfolded);
  std::set<std::size_t> chosen;
  for (std::size_t i = 0; i < graph.clusters.size(); ++i)
    if (std::ranges::find(asked, Json(Parts::clusterId(i))) != asked.end()) chosen.insert(i);
  return chosen;
}

Json picturesJson(const analysis::Program& program) {
  Json all = Json::array();
  for (const auto& picture : viz::allPictures(program))
    all.push_back(
        {{"kind", nameOf(picture.kind)},
         {"name", picture.name},
         {"title", picture.name.empty() ? std::string(nameOf(picture.kind)) : picture.name}});
  return all;
}

bool hasErrors(const ide::View& view) {
  return std::ranges::any_of(view.analysis().diagnostics, [](const auto& diagnostic) {
    return diagnostic.severity == syntax::Severity::Error;
  });
}

std::expected<std::string, RpcError> contentOf(const viz::Graph& graph, const Json& params) {
  const auto format = params.value("format", Json("svg"));
  if (format == "json") return std::string();
  if (format != "svg" && format != "dot")
    return std::unexpected(invalid("`format` is svg, dot or json"));
  const auto scheme = params.value("dark", Json()) == true ? viz::Scheme::Dark : viz::Scheme::Light;
  auto content = viz::render(graph, format == "svg" ? viz::Format::Svg : viz::Format::Dot, scheme);
  if (!content) return std::unexpected(RpcError{ErrorCode::RequestFailed, content.error()});
  return std::move(*content);
}

Answer automaton(const Request& request) {
  auto path = documentPath(request.params);
  if (!path) return std::unexpected(path.error());
  const auto view = request.snapshot.view(*path);
  std::optional<syntax::Offset> caret;
  if (auto position = request.params.find("position"); position != request.params.end()) {
    auto at = offsetOf(view, *position, request.client.encoding);
    if (!at) return std::unexpected(at.error());
    caret = *at;
  }
  auto picture = caret && !request.params.contains("kind")
                     ? std::expected<viz::Request, RpcError>(pictureAt(view, *caret))
                     : pictureNamed(view.program(), request.params);
  if (!picture) return std::unexpected(picture.error());
  picture->forbidden = request.params.value("forbidden", Json()) == true;
  auto graph = viz::draw(view.program(), *picture);
  if (!graph) return std::unexpected(RpcError{ErrorCode::RequestFailed, graph.error()});
  if (request.cancellation.isCancelled())
    return std::unexpected(RpcError{ErrorCode::RequestCancelled, "cancelled"});
  const auto chosen = clustersToFold(*graph, request.params);
  const auto folded = viz::fold(*graph, chosen);
  auto content = contentOf(folded.graph, request.params);
  if (!content) return std::unexpected(content.error());
  const Converter convert(view, request);
  const Parts parts(folded.graph, view.program(), convert);
  Json answer{{"kind", nameOf(picture->kind)},
              {"name", picture->name},
              {"title", graph->title},
              {"note", graph->note},
              {"content", *content},
              {"errors", hasErrors(view)},
              {"nodes", parts.nodes()},
              {"edges", parts.edges()},
              {"clusters", parts.clusters()},
              {"current", caret ? parts.at(view.file, *caret) : Json()},
              {"pictures", picturesJson(view.program())},
              {"foldable", foldableJson(*graph, folded)},
              {"texts", textsJson(view.program(), request.snapshot.open())}};
  if (!request.params.contains("fold") && !chosen.empty())
    answer["foldedBecause"] =
        fmt::format("This picture has {} nodes: branches are folded. Double-click one to open it.",
                    graph->nodes.size());
  return answer;
}

} // namespace

void addAutomaton(Registry& registry) {
  registry.add("proskill/automaton", automaton, Priority::Background);
}

} // namespace proskill::lsp
