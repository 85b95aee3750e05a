#include "lsp/workspace.h"

#include "ide/fiacre_file.h"
#include "lsp/convert.h"
#include "lsp/file_cache.h"
#include "lsp/program_settings.h"
#include "lsp/text_changes.h"

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

/// 0 where the client gives none: `null` is allowed.
std::int64_t versionOf(const Json& document) {
  auto found = document.find("version");
  return found != document.end() && found->is_number_integer() ? found->get<std::int64_t>() : 0;
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
  refresh(*path);
  return *path;
}

Workspace::Outcome Workspace::change(const Json& params) {
  auto path = documentPath(params);
  if (!path) return std::unexpected(path.error().message);
  auto found = texts.find(*path);
  if (found == texts.end()) return std::unexpected("a change of a document that is not open");
  const auto version = versionOf(params["textDocument"]);
  const bool inOrder = version == 0 || version >= found->second.version;
  auto next = inOrder
                  ? changed(found->second.document, memberAt(params, {"contentChanges"}), encoding)
                  : std::nullopt;
  if (next) {
    found->second.document = std::move(*next);
    if (version != 0) found->second.version = version;
    refresh(*path);
    return *path;
  }
  texts.erase(found);
  noteFile(*path);
  refresh(*path);
  return std::unexpected("an edit of `" + path->filename().generic_string() +
                         "` does not fit its text; please close the file and open it again");
}

Workspace::Outcome Workspace::close(const Json& params) {
  auto path = documentPath(params);
  if (!path) return std::unexpected(path.error().message);
  if (texts.erase(*path) == 0) return std::unexpected("a document was closed that is not open");
  noteFile(*path);
  refresh(*path);
  return *path;
}

Workspace::Outcome Workspace::saved(const Json& params) {
  auto path = documentPath(params);
  if (!path) return std::unexpected(path.error().message);
  return *path;
}

FolderContents Workspace::read(const std::vector<fs::path>& folders, const OnFile& onFile) const {
  std::set<fs::path> files;
  for (const auto& folder : folders) files.merge(programFiles(folder));
  FolderContents result;
  for (const auto& file : files) {
    if (auto document = disk->document(file)) result.files[file] = ide::includesOf(file, *document);
    onFile(result.files.size(), files.size());
  }
  return result;
}

void Workspace::add(FolderContents contents) {
  for (auto& [path, targets] : contents.files) {
    known.insert(path);
    if (!texts.contains(path)) includes[path] = std::move(targets);
  }
  startAfresh();
}

void Workspace::forget(const std::vector<fs::path>& folders, const std::vector<fs::path>& staying) {
  auto isIn = [](const fs::path& file, const fs::path& folder) {
    return std::ranges::mismatch(folder, file).in1 == folder.end();
  };
  auto isForgotten = [&](const fs::path& file) {
    auto holds = [&](const fs::path& folder) { return isIn(file, folder); };
    return std::ranges::any_of(folders, holds) && std::ranges::none_of(staying, holds);
  };
  std::erase_if(known, isForgotten);
  std::erase_if(includes, [&](const auto& entry) {
    return !texts.contains(entry.first) && isForgotten(entry.first);
  });
  startAfresh();
}

std::map<fs::path, SettingsMistake> Workspace::mistakes() const {
  std::map<fs::path, SettingsMistake> result;
  std::set<fs::path> looked;
  for (const auto& [path, text] : texts)
    if (looked.insert(path.parent_path()).second)
      if (auto found = settingsFor(*disk, path); found.mistake) result[found.file] = *found.mistake;
  return result;
}

void Workspace::readFiles(const std::vector<fs::path>& paths) {
  for (const auto& path : paths)
    if (path.filename() != kSettingsFile) noteFile(path);
  startAfresh();
}

/// What the disk says of a file.
void Workspace::noteFile(const fs::path& path) {
  auto document = disk->document(path);
  if (document)
    known.insert(path);
  else
    known.erase(path);
  if (texts.contains(path)) return;
  if (document)
    noteIncludes(path, *document);
  else
    includes.erase(path);
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

void Workspace::refresh(const fs::path& edited) {
  if (auto text = texts.find(edited); text != texts.end())
    noteIncludes(edited, text->second.document);
  current = current->with(texts, includes);
}

void Workspace::noteIncludes(const fs::path& path, const syntax::Document& document) {
  includes[path] = ide::includesOf(path, document);
}

std::set<fs::path> programFiles(const fs::path& folder) {
  std::set<fs::path> result;
  std::error_code error;
  fs::recursive_directory_iterator walk(folder, fs::directory_options::skip_permission_denied,
                                        error);
  for (; !error && walk != fs::recursive_directory_iterator(); walk.increment(error)) {
    if (walk->is_directory(error) && isSkipped(walk->path())) walk.disable_recursion_pending();
    const auto& path = walk->path();
    if (path.extension() == ".proskill" || ide::isFiacre(path))
      result.insert(path.lexically_normal());
    if (result.size() == kMostFiles) break;
  }
  return result;
}

} // namespace proskill::lsp
