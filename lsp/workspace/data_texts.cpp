#include "lsp/protocol/convert.h"
#include "lsp/workspace/workspace.h"

#include <algorithm>

namespace proskill::lsp {

namespace {

/// The text after changes that replace it as a whole; nothing if one replaces a part of it.
std::optional<std::string> wholeText(const Json& changes) {
  const auto isWhole = [](const Json& change) {
    return change.is_object() && change.contains("text") && change["text"].is_string() &&
           !change.contains("range");
  };
  if (!changes.is_array() || changes.empty() || !std::ranges::all_of(changes, isWhole))
    return std::nullopt;
  return changes.back()["text"].get<std::string>();
}

std::int64_t versionIn(const Json& params) {
  const auto& version = rpc::memberAt(params, {"textDocument", "version"});
  return version.is_number_integer() ? version.get<std::int64_t>() : 0;
}

} // namespace

bool Workspace::isData(const std::filesystem::path& path) { return path.extension() == ".json"; }

Workspace::Outcome Workspace::setData(const Path& path, DataText text) {
  disk->replaceData(path, text.text);
  data.insert_or_assign(path, std::move(text));
  startAfresh();
  return path;
}

Workspace::Outcome Workspace::openData(const Json& params) {
  const auto path = documentPath(params);
  if (!path) return std::unexpected(path.error().message);
  const auto& document = params["textDocument"];
  if (!document.contains("text") || !document["text"].is_string())
    return std::unexpected("`textDocument.text` is missing");
  return setData(*path, {document["uri"], versionIn(params), document["text"]});
}

Workspace::Outcome Workspace::changeData(const Json& params) {
  const auto path = documentPath(params);
  if (!path) return std::unexpected(path.error().message);
  const auto found = data.find(*path);
  if (found == data.end()) return std::unexpected("a change of a document that is not open");
  auto text = wholeText(rpc::memberAt(params, {"contentChanges"}));
  if (text) return setData(*path, {found->second.uri, versionIn(params), std::move(*text)});
  return closeData(params); // rather the file than a wrong text
}

Workspace::Outcome Workspace::closeData(const Json& params) {
  const auto path = documentPath(params);
  if (!path) return std::unexpected(path.error().message);
  data.erase(*path);
  disk->replaceData(*path, std::nullopt);
  startAfresh();
  return *path;
}

} // namespace proskill::lsp
