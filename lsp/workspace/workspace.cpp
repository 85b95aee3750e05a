#include "lsp/workspace/workspace.h"

#include "ide/snapshot/fiacre_file.h"
#include "lsp/protocol/convert.h"
#include "lsp/workspace/text_changes.h"
#include "report/program_settings.h"

#include <algorithm>
#include <array>

namespace proskill::lsp {

namespace {

namespace fs = std::filesystem;

/// A directory with more programs is probably a whole disk, not a workspace.
constexpr std::size_t kMostFiles = 10'000;

/// 0 if there is none: `null` is allowed.
std::int64_t versionOf(const Json& document) {
  auto found = document.find("version");
  return found != document.end() && found->is_number_integer() ? found->get<std::int64_t>() : 0;
}

/// Whether the file itself is a symbolic link; its directories do not count.
bool isLink(const analysis::FileSystem& disk, const ide::KnownFile& file) {
  return disk.canonical(file.name.parent_path()) / file.name.filename() != file.canonical;
}

/// Resolves includes again if one of these paths has become a link, or was one.
ide::IncludeGraph::File followedAnew(const analysis::FileSystem& disk,
                                     const ide::IncludeGraph::File& file,
                                     const std::set<std::string>& changed) {
  auto isChanged = [&](const auto& include) { return changed.contains(include.path); };
  if (std::ranges::none_of(file->includes, isChanged)) return file;
  auto again = *file;
  for (auto& include : again.includes) include.canonical = disk.canonical(include.path).native();
  return std::make_shared<const ide::KnownFile>(std::move(again));
}

} // namespace

bool isSkippedFolder(const fs::path& folder) {
  constexpr std::array kNames{"node_modules", "build", "install", "log"};
  auto name = folder.filename().string();
  return name.starts_with('.') || std::ranges::find(kNames, name) != kNames.end();
}

bool isProgramFile(const fs::path& path) {
  return path.extension() == ".proskill" || ide::isFiacre(path);
}

Workspace::Workspace(std::shared_ptr<const analysis::FileSystem> files)
    : direct(std::move(files)), disk(std::make_shared<FileCache>(direct)) {
  startAfresh();
}

void Workspace::setStyle(bool now) {
  if (std::exchange(style, now) != now) startAfresh();
}

const InexactText* lostIn(const InexactTexts& texts, const fs::path& path) {
  const auto found = texts.find(path);
  return found != texts.end() && found->second.isLost ? &found->second : nullptr;
}

std::set<fs::path> lostPaths(const InexactTexts& texts) {
  std::set<fs::path> lost;
  for (const auto& [path, text] : texts)
    if (text.isLost) lost.insert(path);
  return lost;
}

bool Workspace::isIncluded(const Json& params) const {
  const auto path = documentPath(params);
  const auto whole = path ? wholeVersions.find(*path) : wholeVersions.end();
  if (whole == wholeVersions.end()) return false;
  const auto version = versionOf(params["textDocument"]);
  return version != 0 && version <= whole->second &&
         !replaceWhole(rpc::memberAt(params, {"contentChanges"}));
}

Workspace::Outcome Workspace::open(const Json& params, ide::TextKind kind, bool hasHalves) {
  auto path = documentPath(params);
  if (!path) return std::unexpected(path.error().message);
  const auto& document = params["textDocument"];
  if (!document.contains("text") || !document["text"].is_string())
    return std::unexpected("`textDocument.text` is missing");
  texts.insert_or_assign(*path,
                         ide::OpenText{document["uri"].get<std::string>(), versionOf(document),
                                       syntax::Document::parse(document["text"]), kind});
  inexact.erase(*path);
  if (hasHalves) inexact[*path] = {document["uri"], kind};
  identities.try_emplace(*path, identityOf(*path));
  noteText(*path);
  refresh();
  return *path;
}

Workspace::Outcome Workspace::change(const Json& params, bool hasHalves) {
  auto path = documentPath(params);
  if (!path) return std::unexpected(path.error().message);
  if (lostIn(inexact, *path)) return restore(*path, params, hasHalves);
  auto found = texts.find(*path);
  if (found == texts.end()) return std::unexpected("a change of a document that is not open");
  auto& text = found->second;
  const auto& changes = rpc::memberAt(params, {"contentChanges"});
  const bool isWhole = replaceWhole(changes);
  const auto version = versionOf(params["textDocument"]);
  if (isIncluded(params)) return *path;
  const bool isExact = isWhole || !hasHalves;
  const bool inOrder = version == 0 || version >= text.version;
  auto next = isExact && inOrder ? changed(text.document, changes, encoding) : std::nullopt;
  if (!next) {
    inexact[*path] = {text.uri, text.kind, true};
    drop(*path);
    const auto name = path->filename().generic_string();
    return std::unexpected(isExact ? "an edit of `" + name + "` does not fit its text"
                                   : "an edit of `" + name + "` contains half a character");
  }
  text.document = std::move(*next);
  if (version != 0) text.version = version;
  if (isWhole) {
    inexact.erase(*path);
    wholeVersions[*path] = version;
  }
  if (hasHalves) inexact[*path] = {text.uri, text.kind};
  noteText(*path);
  refresh();
  return *path;
}

/// Opens a lost text again if the change replaces all of it.
Workspace::Outcome Workspace::restore(const Path& path, const Json& params, bool hasHalves) {
  const auto& changes = rpc::memberAt(params, {"contentChanges"});
  auto whole = replaceWhole(changes) ? changed(syntax::Document::parse(""), changes, encoding)
                                     : std::nullopt;
  if (!whole) return path;
  auto document = params["textDocument"];
  document["text"] = whole->text();
  wholeVersions[path] = versionOf(document);
  return open({{"textDocument", std::move(document)}}, inexact.at(path).kind, hasHalves);
}

Workspace::Outcome Workspace::close(const Json& params) {
  auto path = documentPath(params);
  if (!path) return std::unexpected(path.error().message);
  if (!texts.contains(*path) && !lostIn(inexact, *path))
    return std::unexpected("a document was closed that is not open");
  close(*path);
  return *path;
}

Workspace::Outcome Workspace::saved(const Json& params) {
  auto path = documentPath(params);
  if (!path) return std::unexpected(path.error().message);
  return *path;
}

/// Cells usually belong to the notebook's directory. That path is written without quotes.
bool Workspace::join(const fs::path& notebook, const std::string& uri,
                     const std::vector<fs::path>& cells) {
  std::string text;
  for (const auto& cell : cells) {
    const bool isBeside = cell.parent_path() == notebook.parent_path();
    text += "(include \"" + (isBeside ? cell.filename() : cell).native() + "\")\n";
  }
  const auto found = texts.find(notebook);
  if (found != texts.end() && found->second.document.text() == text) return false;
  texts.insert_or_assign(
      notebook, ide::OpenText{uri, 0, syntax::Document::parse(text), ide::TextKind::Notebook});
  identities.try_emplace(notebook, identityOf(notebook));
  noteText(notebook);
  refresh();
  return true;
}

void Workspace::close(const fs::path& path) {
  inexact.erase(path);
  if (texts.contains(path)) drop(path);
}

FolderContents Workspace::read(const std::vector<fs::path>& folders, const OnFile& onFile) const {
  std::set<fs::path> files;
  for (const auto& folder : folders) files.merge(programFiles(folder));
  FolderContents result;
  for (const auto& file : files) {
    if (auto document = direct->document(file))
      result.files.push_back(
          ide::knownFile(*disk, file, disk->canonical(file).native(), *document));
    onFile(result.files.size(), files.size());
  }
  return result;
}

/// Among several names in the folders, a file keeps its real name if it is there, otherwise the
/// first.
void Workspace::add(FolderContents contents) {
  for (const auto& file : contents.files) {
    auto& name = names[file.canonical];
    if (name.empty() || (name != file.name && !isLink(*disk, file))) name = file.name;
  }
  auto files = graph->files();
  for (auto& file : contents.files)
    if (!isHeld(file.canonical) && names[file.canonical] == file.name)
      files.push_back(std::make_shared<const ide::KnownFile>(std::move(file)));
  graph = std::make_shared<const ide::IncludeGraph>(std::move(files));
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
  std::erase_if(names, [&](const auto& entry) { return isForgotten(entry.second); });
  auto files = graph->files();
  std::erase_if(files, [&](const auto& file) {
    return !texts.contains(file->name) && isForgotten(file->name);
  });
  graph = std::make_shared<const ide::IncludeGraph>(std::move(files));
  startAfresh();
}

std::map<fs::path, report::SettingsMistake> Workspace::mistakes() const {
  std::map<fs::path, report::SettingsMistake> result;
  std::set<fs::path> looked;
  for (const auto& [path, text] : texts)
    if (looked.insert(path.parent_path()).second)
      if (auto found = report::settingsFor(*disk, path); found.mistake)
        result[found.file] = *found.mistake;
  return result;
}

bool Workspace::dependsOn(const fs::path& path) const {
  return !isData(path) || path.filename() == report::kSettingsFile || disk->wasRead(path);
}

void Workspace::readFiles(const std::vector<fs::path>& paths) {
  disk->followAnew();
  std::set<std::string> changed;
  for (const auto& path : paths)
    if (!isData(path)) changed.insert({path.native(), disk->canonical(path).native()});
  for (const auto& file : graph->files())
    if (changed.contains(file->name.native())) changed.insert(file->canonical);
  std::vector<ide::IncludeGraph::File> files;
  for (const auto& file : graph->files())
    if (!changed.contains(file->canonical) || isHeld(file->canonical))
      files.push_back(followedAnew(*disk, file, changed));
  for (const auto& path : changed)
    if (auto file = onDisk(path); file && !isHeld(file->canonical))
      files.push_back(std::make_shared<const ide::KnownFile>(std::move(*file)));
  graph = std::make_shared<const ide::IncludeGraph>(std::move(files));
  startAfresh();
}

/// The file on the disk at a path, under its previous name if that still leads there.
std::optional<ide::KnownFile> Workspace::onDisk(const fs::path& path) {
  const auto canonical = disk->canonical(path).native();
  const auto document = disk->document(path);
  if (!document) {
    names.erase(canonical);
    return std::nullopt;
  }
  auto& name = names.try_emplace(canonical, path).first->second;
  if (name != path && disk->canonical(name).native() != canonical) name = path;
  return ide::knownFile(*disk, name, canonical, *document);
}

bool Workspace::isHeld(std::string_view canonical) const {
  return std::ranges::any_of(identities | std::views::values,
                             [&](const auto& identity) { return identity == canonical; });
}

std::string Workspace::identityOf(const fs::path& path) const {
  auto canonical = disk->canonical(path).native();
  return isHeld(canonical) ? path.native() : canonical;
}

/// Most edits change no include, and need no access to the disk.
void Workspace::noteText(const fs::path& path) {
  const auto& document = texts.at(path).document;
  const auto& identity = identities.at(path);
  const auto* known = graph->find(identity);
  if (known && known->name == path && ide::includesAsBefore(*known, document)) return;
  graph = graph->with(ide::knownText(*disk, path, identity, document));
}

/// Replaces a closed text by the file on the disk, unless it is open under another name. Files of
/// notebooks are usually not programs.
void Workspace::drop(const fs::path& path) {
  wholeVersions.erase(path);
  const bool mayBeFile = texts.at(path).kind == ide::TextKind::File || isProgramFile(path);
  texts.erase(path);
  const auto identity = identities.extract(path).mapped();
  graph = graph->without(identity);
  if (const auto other = otherTextOf(identity)) {
    graph = graph->without(std::exchange(identities.at(*other), identity));
    noteText(*other);
  } else if (auto file = mayBeFile ? onDisk(path) : std::nullopt;
             file && !isHeld(file->canonical)) {
    graph = graph->with(std::move(*file));
  }
  refresh();
}

/// A text of the same file that is open under another name.
std::optional<fs::path> Workspace::otherTextOf(std::string_view canonical) const {
  for (const auto& [path, identity] : identities)
    if (disk->canonical(path).native() == canonical) return path;
  return std::nullopt;
}

/// Discards all analyses: a file's text or the settings have changed.
void Workspace::startAfresh() {
  auto settings = [disk = disk, style = style](const fs::path& root) {
    auto found = report::settingsFor(*disk, root).settings;
    found.style |= style;
    return found;
  };
  current = std::make_shared<ide::Snapshot>(disk, texts, graph, settings);
}

void Workspace::refresh() { current = current->with(texts, graph); }

std::set<fs::path> programFiles(const fs::path& folder) {
  std::set<fs::path> result;
  std::error_code error;
  fs::recursive_directory_iterator walk(folder, fs::directory_options::skip_permission_denied,
                                        error);
  for (; !error && walk != fs::recursive_directory_iterator(); walk.increment(error)) {
    if (walk->is_directory(error) && isSkippedFolder(walk->path()))
      walk.disable_recursion_pending();
    const auto& path = walk->path();
    if (isProgramFile(path)) result.insert(path.lexically_normal());
    if (result.size() == kMostFiles) break;
  }
  return result;
}

} // namespace proskill::lsp
