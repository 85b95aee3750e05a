#include "ide/rename.h"
#include "lsp/convert.h"
#include "lsp/uri.h"

namespace proskill::lsp {

namespace {

RpcError refused(std::string why) { return {ErrorCode::RequestFailed, std::move(why)}; }

Answer prepareRename(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  auto found = ide::renameable(at->view, at->at);
  if (!found) return std::unexpected(refused(found.error()));
  const Converter convert(at->view, request);
  return Json{{"range", convert.range(found->at)},
              {"placeholder", at->view.index().symbols()[found->symbol].name}};
}

/// One file's edits, in the protocol's two ways to write them.
void addEdits(Json& result, const std::filesystem::path& path,
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

Answer rename(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  const auto& name = memberAt(request.params, {"newName"});
  if (!name.is_string())
    return std::unexpected(RpcError{ErrorCode::InvalidParams, "`newName` is missing"});
  auto plan = ide::rename(request.snapshot, at->view, at->at, name.get_ref<const std::string&>());
  if (!plan) return std::unexpected(refused(plan.error()));
  Json result = request.client.documentChanges ? Json{{"documentChanges", Json::array()}}
                                               : Json{{"changes", Json::object()}};
  for (const auto& [path, ranges] : plan->places)
    addEdits(result, path, ranges, plan->text, request);
  return result;
}

Answer linkedEditing(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  const auto places = ide::linkedPlaces(at->view, at->at);
  if (places.empty()) return nullptr;
  const Converter convert(at->view, request);
  Json ranges = Json::array();
  for (auto range : places) ranges.push_back(convert.range(at->view.file, range));
  return Json{{"ranges", std::move(ranges)}, {"wordPattern", "[A-Za-z_][A-Za-z0-9_]*"}};
}

} // namespace

void addRename(Registry& registry) {
  registry.capabilities["renameProvider"] = {{"prepareProvider", true}};
  registry.capabilities["linkedEditingRangeProvider"] = true;
  registry.add("textDocument/prepareRename", prepareRename);
  registry.add("textDocument/rename", rename);
  registry.add("textDocument/linkedEditingRange", linkedEditing);
}

} // namespace proskill::lsp
