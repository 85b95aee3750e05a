#pragma once

#include "lsp/protocol/client.h"
#include "lsp/workspace/workspace.h"
#include "rpc/inbox.h"
#include "rpc/peer.h"
#include "rpc/scheduler.h"

#include <filesystem>
#include <functional>
#include <vector>

namespace proskill::lsp {

/// The folders that the client has open. They are read in the background, so that edits and
/// requests do not wait for a large folder. For the main thread.
class ClientFolders {
public:
  using Path = std::filesystem::path;

  /// The parts of the server that folders need; they must outlive them.
  struct Server {
    Workspace& workspace;
    rpc::Peer& peer;
    const ClientFeatures& client;
    rpc::Inbox& inbox;
    rpc::Scheduler& scheduler;
    std::function<void()> onRead; ///< on the main thread, when folders have been read
  };

  explicit ClientFolders(Server server) : server(std::move(server)) {}

  /// Sets the folders of `initialize`; `readAll` reads them.
  void set(std::vector<Path> all) { folders = std::move(all); }
  void readAll() { read(folders); }
  void change(const std::vector<Path>& removed, std::vector<Path> added);
  /// The files to read again after a change of some paths on disk. A folder that has come or gone
  /// stands for the program files that are in it, and that were.
  [[nodiscard]] std::vector<Path> filesOf(const std::vector<Path>& paths) const;
  /// Files have changed on disk. A read in progress may have older contents.
  void filesChanged(const std::vector<Path>& paths);

private:
  [[nodiscard]] bool mayHoldPrograms(const Path& folder) const;
  void read(std::vector<Path> some);
  void catchUp();

  Server server;
  std::vector<Path> folders;
  unsigned readings = 0; ///< in progress
  std::vector<Path> changedMeanwhile;
  std::vector<Path> removedMeanwhile;
};

} // namespace proskill::lsp
