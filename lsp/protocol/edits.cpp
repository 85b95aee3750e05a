#include "lsp/protocol/edits.h"

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
             const std::vector<syntax::TextEdit>& edits, const Request& request) {
  const auto view = request.snapshot.view(path);
  const Converter convert(view, request);
  const auto uri = convert.uri(view.file);
  auto written = textEdits(convert, view.file, edits);
  if (!request.client.documentChanges) {
    result["changes"][uri] = std::move(written);
    return;
  }
  const auto open = request.snapshot.open().find(path);
  const Json version =
      open == request.snapshot.open().end() ? Json(nullptr) : Json(open->second.version);
  result["documentChanges"].push_back(
      {{"textDocument", {{"uri", uri}, {"version", version}}}, {"edits", std::move(written)}});
}

} // namespace

Json workspaceEdit(const FileEdits& edits, const Request& request) {
  Json result = request.client.documentChanges ? Json{{"documentChanges", Json::array()}}
                                               : Json{{"changes", Json::object()}};
  for (const auto& [path, ofFile] : edits) addFile(result, path, ofFile, request);
  return result;
}

Json workspaceEdit(const std::map<std::filesystem::path, std::vector<syntax::Range>>& places,
                   const std::string& text, const Request& request) {
  FileEdits edits;
  for (const auto& [path, ranges] : places)
    for (auto range : ranges) edits[path].push_back({range, text});
  return workspaceEdit(edits, request);
}

} // namespace proskill::lsp
