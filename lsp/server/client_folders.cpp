#include "lsp/server/client_folders.h"

#include "lsp/protocol/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

namespace proskill::lsp {

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
