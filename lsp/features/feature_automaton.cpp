#include "lsp/protocol/convert.h"
#include "lsp/verification/verdict_json.h"
#include "report/picture_json.h"
#include "viz/dot/part_ids.h"
#include "viz/render.h"

#include <algorithm>
#include <map>

/// `proskill/automaton`: pictures, with the source ranges of their parts.
namespace proskill::lsp {

namespace {

/// The picture of a definition; by default the call graph.
viz::Request pictureOf(const syntax::Form& form) {
  using viz::Kind;
  if (const auto* variable = form.as<syntax::StateVariable>())
    return {Kind::StateVariable, std::string(variable->name.text), false};
  if (const auto* event = form.as<syntax::Event>(); event && (event->every || event->guard))
    return {Kind::Event, std::string(event->name.text), false};
  if (const auto* skill = form.as<syntax::Skill>())
    return {skill->isComposite() ? Kind::Body : Kind::Skill, std::string(skill->name.text), false};
  if (const auto* environment = form.as<syntax::Environment>())
    return {Kind::Body, std::string(environment->name.text), false};
  return {};
}

viz::Request pictureAt(const ide::View& view, syntax::Offset at) {
  for (const auto& form : view.document().forms())
    if (form.range.begin <= at && at <= form.range.end) return pictureOf(form);
  return {};
}

/// The picture of whatever has this name.
std::expected<viz::Request, rpc::RpcError> pictureOf(const analysis::Program& program,
                                                     const std::string& name) {
  for (const auto& file : program.files)
    for (const auto& form : file.document.forms())
      if (auto picture = pictureOf(form); picture.name == name) return picture;
  return std::unexpected(requestFailed("nothing is called `" + name + "`"));
}

std::expected<viz::Request, rpc::RpcError> pictureNamed(const analysis::Program& program,
                                                        const Json& params) {
  auto kind = params.value("kind", Json());
  auto name = params.value("name", Json(""));
  if (kind.is_null() && name.is_string() && !name.get_ref<const std::string&>().empty())
    return pictureOf(program, name.get_ref<const std::string&>());
  const auto known =
      kind.is_string() ? viz::kindOf(kind.get_ref<const std::string&>()) : std::nullopt;
  if (!known)
    return std::unexpected(invalidParams("`kind` must be sv, event, skill, body or calls"));
  if (!name.is_string()) return std::unexpected(invalidParams("`name` must be a string"));
  return viz::Request{*known, name.get<std::string>(), false};
}

/// The part with the smallest range around a position: nodes come before edges, and edges before
/// clusters.
Json partAt(const viz::Graph& graph, const std::string& file, syntax::Offset offset) {
  Json best;
  syntax::Offset length = 0;
  auto offer = [&](const viz::Source& source, const std::string& id) {
    const bool holds = source.file == file && source.range.begin <= offset &&
                       offset <= source.range.end && !source.range.empty();
    if (!holds || (!best.is_null() && source.range.length() >= length)) return;
    best = id;
    length = source.range.length();
  };
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) offer(graph.nodes[i].source, viz::nodeId(i));
  if (!best.is_null()) return best;
  for (std::size_t i = 0; i < graph.edges.size(); ++i)
    if (graph.edges[i].source) offer(*graph.edges[i].source, viz::edgeId(i));
  if (!best.is_null()) return best;
  for (std::size_t i = 0; i < graph.clusters.size(); ++i)
    offer(graph.clusters[i].source, viz::clusterId(i));
  return best;
}

report::PlaceJson placesIn(const analysis::Program& program, const Converter& convert) {
  std::map<std::string, analysis::FileId> files;
  for (analysis::FileId i = 0; i < program.files.size(); ++i)
    files[program.files[i].path.string()] = i;
  return [files = std::move(files), &convert](const viz::Source& source) -> Json {
    auto found = files.find(source.file);
    return found == files.end() ? Json() : convert.location({found->second, source.range});
  };
}

report::FoldKeys foldKeys(const Json& params) {
  const auto asked = params.value("fold", Json());
  if (!asked.is_array()) return std::nullopt;
  std::vector<std::string> keys;
  for (const auto& key : asked)
    if (key.is_string()) keys.push_back(key.get<std::string>());
  return keys;
}

bool hasErrors(const ide::View& view) {
  return std::ranges::any_of(view.analysis().diagnostics, [](const auto& diagnostic) {
    return diagnostic.severity == syntax::Severity::Error;
  });
}

std::expected<std::string, rpc::RpcError> contentOf(const viz::Graph& graph, const Json& params) {
  const auto format = params.value("format", Json("svg"));
  if (format == "json") return std::string();
  if (format != "svg" && format != "dot")
    return std::unexpected(invalidParams("`format` must be svg, dot or json"));
  const auto scheme = params.value("dark", Json()) == true ? viz::Scheme::Dark : viz::Scheme::Light;
  auto content = viz::render(graph, format == "svg" ? viz::Format::Svg : viz::Format::Dot, scheme);
  if (!content) return std::unexpected(requestFailed(content.error()));
  return std::move(*content);
}

Answer automaton(const Request& request) {
  auto path = documentFile(request);
  if (!path) return std::unexpected(path.error());
  const auto view = request.snapshot.view(*path);
  std::optional<syntax::Offset> caret;
  if (auto position = request.params.find("position"); position != request.params.end()) {
    auto at = offsetOf(view, *position, request.client.encoding);
    if (!at) return std::unexpected(at.error());
    caret = *at;
  }
  auto picture = caret && !request.params.contains("kind")
                     ? std::expected<viz::Request, rpc::RpcError>(pictureAt(view, *caret))
                     : pictureNamed(view.program(), request.params);
  if (!picture) return std::unexpected(picture.error());
  picture->forbidden = request.params.value("forbidden", Json()) == true;
  auto drawn = report::drawPicture(view.program(), *picture, foldKeys(request.params));
  if (!drawn) return std::unexpected(requestFailed(drawn.error()));
  if (request.cancellation.isCancelled())
    return std::unexpected(rpc::RpcError{rpc::ErrorCode::RequestCancelled, "cancelled"});
  const auto& graph = drawn->folded.graph;
  auto content = contentOf(graph, request.params);
  if (!content) return std::unexpected(content.error());
  const Converter convert(view, request);
  Json answer = report::pictureJson(*drawn, placesIn(view.program(), convert));
  answer["content"] = std::move(*content);
  answer["errors"] = hasErrors(view);
  answer["current"] =
      caret ? partAt(graph, view.program().files[view.file].path.string(), *caret) : Json();
  answer["pictures"] = report::picturesJson(view.program());
  answer["texts"] = textsJson(view.program(), request.snapshot.open());
  return answer;
}

} // namespace

void addAutomaton(Registry& registry) {
  registry.add("proskill/automaton", automaton, rpc::Priority::Background);
}

} // namespace proskill::lsp
