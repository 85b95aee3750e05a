#include "ide/features/moved_files.h"
#include "ide/features/rename.h"
#include "lsp/protocol/convert.h"
#include "lsp/protocol/edits.h"

namespace proskill::lsp {

namespace {

Answer prepareRename(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  auto found = ide::renameable(at->view, at->at);
  if (!found) return std::unexpected(requestFailed(found.error()));
  const Converter convert(at->view, request);
  return Json{{"range", convert.range(found->at)},
              {"placeholder", at->view.index().symbols()[found->symbol].name}};
}

Answer rename(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  auto name = textIn(request.params, "newName");
  if (!name) return std::unexpected(name.error());
  auto plan = ide::rename(request.snapshot, at->view, at->at, *name);
  if (!plan) return std::unexpected(requestFailed(plan.error()));
  return workspaceEdit(plan->places, plan->text, request);
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

/// Updates includes when an editor renames files.
Answer willRenameFiles(const Request& request) {
  const auto& files = rpc::memberAt(request.params, {"files"});
  std::vector<ide::Move> moves;
  for (const auto& file : files.is_array() ? files : Json::array()) {
    const auto from = textIn(file, "oldUri");
    const auto to = textIn(file, "newUri");
    if (!from || !to) return std::unexpected(from ? to.error() : from.error());
    moves.push_back({request.snapshot.nameOf(pathOf(*from)), pathOf(*to)});
  }
  const auto edits = ide::includesAfter(request.snapshot, moves);
  return edits.empty() ? Json() : workspaceEdit(edits, request);
}

/// Filters for programs, models and their directories.
Json renamedFiles() {
  return {
      {"filters",
       {{{"scheme", "file"}, {"pattern", {{"glob", "**/*.{proskill,fcr}"}, {"matches", "file"}}}},
        {{"scheme", "file"}, {"pattern", {{"glob", "**"}, {"matches", "folder"}}}}}}};
}

} // namespace

void addRename(Registry& registry) {
  registry.capabilities["workspace"]["fileOperations"]["willRename"] = renamedFiles();
  registry.add("workspace/willRenameFiles", willRenameFiles);
  registry.capabilities["renameProvider"] = {{"prepareProvider", true}};
  registry.capabilities["linkedEditingRangeProvider"] = true;
  registry.add("textDocument/prepareRename", prepareRename);
  registry.add("textDocument/rename", rename);
  registry.add("textDocument/linkedEditingRange", linkedEditing);
}

} // namespace proskill::lsp
