#include "lsp/protocol/convert.h"

#include "report/uri.h"

namespace proskill::lsp {

namespace {

/// A coordinate; larger numbers are clamped, since they are beyond any text.
std::optional<std::uint32_t> coordinate(const Json& position, const char* name) {
  if (!position.is_object()) return std::nullopt;
  auto found = position.find(name);
  if (found == position.end() || !found->is_number_unsigned()) return std::nullopt;
  return static_cast<std::uint32_t>(
      std::min<std::uint64_t>(found->get<std::uint64_t>(), UINT32_MAX));
}

} // namespace

rpc::RpcError invalidParams(std::string message) {
  return {rpc::ErrorCode::InvalidParams, std::move(message)};
}

rpc::RpcError requestFailed(std::string message) {
  return {rpc::ErrorCode::RequestFailed, std::move(message)};
}

Json Converter::position(analysis::FileId file, syntax::Offset at) const {
  const auto& document = program.files[file].document;
  auto position = syntax::toEditor(document.text(), document.lines(), at, encoding, line);
  return {{"line", position.line}, {"character", position.character}};
}

Json Converter::range(analysis::FileId file, syntax::Range range) const {
  return {{"start", position(file, range.begin)}, {"end", position(file, range.end)}};
}

Json Converter::location(analysis::Location location) const {
  return {{"uri", uri(location.file)}, {"range", range(location)}};
}

void Converter::write(rpc::JsonWriter& json, analysis::FileId file, syntax::Range range) const {
  const auto& document = program.files[file].document;
  auto point = [&](const char* name, syntax::Offset at) {
    const auto position = syntax::toEditor(document.text(), document.lines(), at, encoding, line);
    json.key(name).open('{').key("line").line(position.line);
    json.member("character", position.character).close('}');
  };
  json.open('{');
  point("start", range.begin);
  point("end", range.end);
  json.close('}');
}

void Converter::write(rpc::JsonWriter& json, analysis::Location location) const {
  write(json.open('{').member("uri", uri(location.file)).key("range"), location.file,
        location.range);
  json.close('}');
}

bool Converter::isShown(analysis::FileId file) const {
  const auto open = texts.find(program.files[file].path);
  return open == texts.end() || open->second.kind != ide::TextKind::Notebook;
}

std::string Converter::uri(analysis::FileId file) const {
  const auto& path = program.files[file].path;
  auto open = texts.find(path);
  return open == texts.end() ? report::toUri(path) : open->second.uri;
}

std::filesystem::path pathOf(std::string_view uri) {
  if (auto path = report::toPath(uri)) return *path;
  if (auto path = report::toCellPath(uri)) return *path;
  return "/" + std::string(uri);
}

std::expected<std::filesystem::path, rpc::RpcError> documentPath(const Json& params) {
  if (!params.is_object() || !params.contains("textDocument"))
    return std::unexpected(invalidParams("`textDocument` is missing"));
  const auto& document = params["textDocument"];
  if (!document.is_object() || !document.contains("uri") || !document["uri"].is_string())
    return std::unexpected(invalidParams("`textDocument.uri` is missing"));
  return pathOf(document["uri"].get<std::string>());
}

std::string uriOf(const std::filesystem::path& file, const ide::Snapshot& snapshot) {
  const auto name = snapshot.nameOf(file);
  const auto open = snapshot.open().find(name);
  return open == snapshot.open().end() ? report::toUri(name) : open->second.uri;
}

std::expected<std::filesystem::path, rpc::RpcError> documentFile(const Request& request) {
  auto path = documentPath(request.params);
  return path ? request.snapshot.nameOf(*path) : path;
}

Json listAnswer(const Request& request, std::string_view list) {
  return request.progress->wantsParts() ? Json::parse(list) : rpc::written(list);
}

std::expected<std::string, rpc::RpcError> textIn(const Json& params, const char* name) {
  const auto& text = rpc::memberAt(params, {name});
  if (!text.is_string())
    return std::unexpected(invalidParams("`" + std::string(name) + "` is missing"));
  return text.get<std::string>();
}

std::expected<ide::View, rpc::RpcError> documentView(const Request& request) {
  auto path = documentPath(request.params);
  if (!path) return std::unexpected(path.error());
  if (!request.snapshot.open().contains(*path) ||
      request.snapshot.kindOf(*path) == ide::TextKind::Notebook)
    return std::unexpected(invalidParams("the document is not open"));
  return request.snapshot.view(*path);
}

std::expected<syntax::Offset, rpc::RpcError> offsetOf(const ide::View& view, const Json& position,
                                                      syntax::Encoding encoding) {
  auto line = coordinate(position, "line");
  auto character = coordinate(position, "character");
  if (!line || !character)
    return std::unexpected(invalidParams("a position must have a line and a character"));
  return syntax::fromEditor(view.text(), view.document().lines(), {*line, *character}, encoding);
}

std::expected<Cursor, rpc::RpcError> cursor(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  if (!request.params.contains("position"))
    return std::unexpected(invalidParams("`position` is missing"));
  auto at = offsetOf(*view, request.params["position"], request.client.encoding);
  if (!at) return std::unexpected(at.error());
  return Cursor{std::move(*view), *at};
}

std::expected<syntax::Range, rpc::RpcError> rangeOf(const ide::View& view, const Json& range,
                                                    syntax::Encoding encoding) {
  if (!range.is_object() || !range.contains("start") || !range.contains("end"))
    return std::unexpected(invalidParams("a range must have a start and an end"));
  auto begin = offsetOf(view, range["start"], encoding);
  if (!begin) return std::unexpected(begin.error());
  auto end = offsetOf(view, range["end"], encoding);
  if (!end) return std::unexpected(end.error());
  return syntax::Range{std::min(*begin, *end), std::max(*begin, *end)};
}

std::expected<syntax::Range, rpc::RpcError> rangeIn(const ide::View& view, const Json& params,
                                                    syntax::Encoding encoding) {
  if (!params.contains("range")) return std::unexpected(invalidParams("`range` is missing"));
  return rangeOf(view, params["range"], encoding);
}

} // namespace proskill::lsp
