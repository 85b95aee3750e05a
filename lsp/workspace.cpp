#include "lsp/workspace.h"

#include "lsp/convert.h"
#include "lsp/program_settings.h"

#include <algorithm>
#include <array>

namespace proskill::lsp {

namespace {

namespace fs = std::filesystem;

/// A folder of more programs than this is no workspace but somebody's disk.
constexpr std::size_t kMostFiles = 10'000;

bool isSkipped(const fs::path& folder) {
  constexpr std::array kNames{"node_modules", "build", "install", "log"};
  auto name = folder.filename().string();
  return name.starts_with('.') || std::ranges::find(kNames, name) != kNames.end();
}

std::optional<EditorPosition> editorPosition(const Json& json) {
  if (!json.is_object() || !json.contains("line") || !json.contains("character"))
    return std::nullopt;
  const auto& line = json["line"];
  const auto& character = json["character"];
  if (!line.is_number_unsigned() || !character.is_number_unsigned()) return std::nullopt;
  return EditorPosition{line.get<std::uint32_t>(), character.get<std::uint32_t>()};
}

/// 0 where the client gives none: `null` is allowed.
std::int64_t versionOf(const Json& document) {
  auto found = document.find("version");
  return found != document.end() && found->is_number_integer() ? found->get<std::int64_t>() : 0;
}

/// The bytes that a change replaces; nothing where its range is none of the text.
std::optional<syntax::Range> changedRange(const syntax::Document& document, const Json& range,
                                          Encoding encoding) {
  if (!range.is_object() || !range.contains("start") || !range.contains("end")) return std::nullopt;
  auto start = editorPosition(range["start"]);
  auto end = editorPosition(range["end"]);
  if (!start || !end || *end < *start) return std::nullopt;
  if (end->line > document.lines().lineCount()) return std::nullopt;
  auto offset = [&](EditorPosition at) {
    return fromEditor(document.text(), document.lines(), at, encoding);
  };
  return syntax::Range{offset(*start), offset(*end)};
}

std::optional<syntax::Document> changed(const syntax::Document& document, const Json& change,
                                        Encoding encoding) {
  if (!change.is_object() || !change.contains("text") || !change["text"].is_string())
    return std::nullopt;
  const auto& text = change["text"].get_ref<const std::string&>();
  if (!change.contains("range")) return syntax::Document::parse(text);
  auto range = changedRange(document, change["range"], encoding);
  if (!range) return std::nullopt;
  return document.edit(*range, text);
}

} // namespace

Workspace::Workspace(std::shared_ptr<const analysis::FileSystem> files) : disk(std::move(files)) {
  startAfresh();
}

void Workspace::setStyle(bool now) {
  if (std::exchange(style, now) != now) startAfresh();
}

Workspace::Outcome Workspace::open(const Json& params) {
  auto path = documentPath(params);
  if (!path) return std::unexpected(path.error().message);
  const auto& document = params["textDocument"];
  if (!document.contains("text") || !document["text"].is_string())
    return std::unexpected("`textDocument.text` is missing");
  texts.insert_or_assign(*path,
                         ide::OpenText{document["uri"].get<std::string>(), versionOf(document),
                                       syntax::Document::parse(document["text"])});
  refresh();
  return *path;
}

Workspace::Outcome Workspace::change(const Json& params) {
  auto path = documentPath(params);
  if (!path) return std::unexpected(path.error().message);
  auto found = texts.find(*path);
  if (found == texts.end()) return std::unexpected("a change of a document that is not open");
  const auto& changes = params.contains("contentChanges") ? params["contentChanges"] : Json();
  auto applied = apply(*path, found->second, changes);
  if (applied)
    found->second.version = versionOf(params["textDocument"]);
  else
    texts.erase(found);
  refresh();
  return applied;
}

Workspace::Outcome Workspace::apply(const fs::path& path, ide::OpenText& text,
                                    const Json& changes) {
  if (!changes.is_array()) return std::unexpected("`contentChanges` is missing");
  for (const auto& change : changes) {
    auto next = changed(text.document, change, encoding);
    if (!next) return std::unexpected("a change that does not fit the document; please reopen it");
    text.document = std::move(*next);
  }
  return path;
}

Workspace::Outcome Workspace::close(const Json& params) {
  auto path = documentPath(params);
  if (!path) return std::unexpected(path.error().message);
  if (texts.erase(*path) == 0) return std::unexpected("a document was closed that is not open");
  readFiles({*path});
  return *path;
}

void Workspace::readFiles(const std::vector<fs::path>& paths) {
  for (const auto& path : paths) {
    if (path.filename() == kSettingsFile) continue;
    auto document = disk->document(path);
    if (!document) {
      known.erase(path);
      if (!texts.contains(path)) includes.erase(path);
      continue;
    }
    known.insert(path);
    if (!texts.contains(path)) noteIncludes(path, *document);
  }
  startAfresh();
}

/// Whatever was analysed with a file's old text, or by other settings, is out of date: nothing is
/// taken over.
void Workspace::startAfresh() {
  auto settings = [disk = disk, style = style](const fs::path& root) {
    auto found = settingsFor(*disk, root).settings;
    found.style |= style;
    return found;
  };
  current = std::make_shared<ide::Snapshot>(disk, texts, includes, settings);
}

void Workspace::refresh() {
  for (const auto& [path, text] : texts) noteIncludes(path, text.document);
  current = current->with(texts, includes);
}

void Workspace::noteIncludes(const fs::path& path, const syntax::Document& document) {
  includes[path] = ide::includesOf(path, document);
}

std::vector<fs::path> programFiles(const fs::path& folder) {
  std::vector<fs::path> result;
  std::error_code error;
  fs::recursive_directory_iterator walk(folder, fs::directory_options::skip_permission_denied,
                                        error);
  for (; !error && walk != fs::recursive_directory_iterator(); walk.increment(error)) {
    if (walk->is_directory(error) && isSkipped(walk->path())) walk.disable_recursion_pending();
    if (walk->path().extension() == ".proskill") result.push_back(walk->path().lexically_normal());
    if (result.size() == kMostFiles) break;
  }
  std::ranges::sort(result);
  return result;
}

} // namespace proskill::lsp
