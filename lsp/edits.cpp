#include "lsp/edits.h"

namespace proskill::lsp {

Json textEdits(const Converter& convert, analysis::FileId file,
               std::span<const syntax::TextEdit> edits) {
  Json result = Json::array();
  for (const auto& edit : edits)
    result.push_back({{"range", convert.range(file, edit.range)}, {"newText", edit.text}});
  return result;
}

namespace {

void addFile(Json& result, const std::filesystem::path& path,
             const std::vector<syntax::Range>& ranges, const std::string& text,
             const Request& request) {
  const auto view = request.snapshot.view(path);
  const Converter convert(view, request);
  Json edits = Json::array();
  for (auto range : ranges)
    edits.push_back({{"range", convert.range(view.file, range)}, {"newText", text}});
  const auto uri = convert.uri(view.file);
  if (!request.client.documentChanges) {
    result["changes"][uri] = std::move(edits);
    return;
  }
  const auto open = request.snapshot.open().find(path);
  const Json version =
      open == request.snapshot.open().end() ? Json(nullptr) : Json(open->second.version);
  result["documentChanges"].push_back(
      {{"textDocument", {{"uri", uri}, {"version", version}}}, {"edits", std::move(edits)}});
}

} // namespace

Json workspaceEdit(const std::map<std::filesystem::path, std::vector<syntax::Range>>& places,
                   const std::string& text, const Request& request) {
  Json result = request.client.documentChanges ? Json{{"documentChanges", Json::array()}}
                                               : Json{{"changes", Json::object()}};
  for (const auto& [path, ranges] : places) addFile(result, path, ranges, text, request);
  return result;
}

} // namespace proskill::lsp
