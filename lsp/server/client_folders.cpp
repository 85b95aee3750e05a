#include "lsp/server/client_folders.h"

#include "lsp/protocol/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

namespace proskill::lsp {

namespace {

using Path = std::filesystem::path;

/// Whether the path leads from the folder to something in it, through no folder that is skipped.
bool leadsIn(const Path& path, const Path& folder) {
  const auto [rest, end] = std::ranges::mismatch(path, folder);
  return end == folder.end() && std::none_of(rest, path.end(), isSkippedFolder);
}

/// The known files below a folder, which may be gone.
std::vector<Path> knownBelow(const Path& folder, const ide::IncludeGraph& graph) {
  const auto start = (folder / "").native();
  std::vector<Path> result;
  const auto first = std::ranges::lower_bound(graph.files(), start, {}, &ide::KnownFile::canonical);
  for (auto it = first; it != graph.files().end() && (*it)->canonical.starts_with(start); ++it)
    result.push_back((*it)->name);
  return result;
}

} // namespace

std::vector<Path> ClientFolders::filesOf(const std::vector<Path>& paths) const {
  const auto& graph = *server.workspace.snapshot()->includes();
  std::vector<Path> result;
  for (const auto& path : paths) {
    if (isProgramFile(path) || Workspace::isData(path) || graph.named(path)) {
      result.push_back(path);
      continue;
    }
    std::ranges::move(knownBelow(path, graph), std::back_inserter(result));
    if (mayHoldPrograms(path)) std::ranges::copy(programFiles(path), std::back_inserter(result));
  }
  return result;
}

bool ClientFolders::mayHoldPrograms(const Path& folder) const {
  return std::ranges::any_of(folders, [&](const Path& open) { return leadsIn(folder, open); });
}

void ClientFolders::change(const std::vector<Path>& removed, std::vector<Path> added) {
  std::erase_if(folders, [&](const Path& it) { return std::ranges::count(removed, it) > 0; });
  server.workspace.forget(removed, folders);
  if (readings > 0) removedMeanwhile.insert(removedMeanwhile.end(), removed.begin(), removed.end());
  folders.insert(folders.end(), added.begin(), added.end());
  read(std::move(added));
}

void ClientFolders::filesChanged(const std::vector<Path>& paths) {
  if (readings > 0) changedMeanwhile.insert(changedMeanwhile.end(), paths.begin(), paths.end());
  server.workspace.readFiles(paths);
}

/// Progress is shown once the client has accepted it; most folders are read faster than that.
void ClientFolders::read(std::vector<Path> some) {
  if (some.empty()) return;
  auto agreed = std::make_shared<std::atomic<bool>>(false);
  const std::string token = "proskill/folders/" + some.front().generic_string();
  if (server.client.workDoneProgress)
    server.peer.ask("window/workDoneProgress/create", {{"token", token}},
                    [agreed](const Json&) { *agreed = true; });
  ++readings;
  server.scheduler.post(rpc::Priority::Background, [this, some = std::move(some), agreed, token] {
    Progress progress([this](auto what, const Json& params) { server.peer.notify(what, params); },
                      token, nullptr);
    auto found = std::make_shared<FolderContents>(
        server.workspace.read(some, [&](std::size_t done, std::size_t all) {
          if (!*agreed) return;
          progress.begin("Reading programs", false);
          progress.report(fmt::format("{} of {} files", done, all),
                          static_cast<unsigned>(100 * done / all));
        }));
    server.inbox.put([this, found] {
      server.workspace.add(std::move(*found));
      catchUp();
      server.onRead();
    });
  });
}

/// Applies changes that were reported while folders were read, since they are newer.
void ClientFolders::catchUp() {
  if (!changedMeanwhile.empty()) server.workspace.readFiles(changedMeanwhile);
  if (!removedMeanwhile.empty()) server.workspace.forget(removedMeanwhile, folders);
  if (--readings > 0) return;
  changedMeanwhile.clear();
  removedMeanwhile.clear();
}

} // namespace proskill::lsp
