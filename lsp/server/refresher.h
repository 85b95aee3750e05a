#pragma once

#include "ide/snapshot/snapshot.h"
#include "lsp/protocol/client.h"
#include "rpc/peer.h"

#include <atomic>
#include <chrono>
#include <optional>
#include <set>

namespace proskill::lsp {

/// Sends refresh requests for open texts whose answers may have changed by
/// something other than an edit of the text itself.
class Refresher {
public:
  using Time = std::chrono::steady_clock::time_point;
  using Path = std::filesystem::path;
  using Snapshot = std::shared_ptr<const ide::Snapshot>;

  /// Both outlive the refresher.
  Refresher(rpc::Peer& peer, const ClientFeatures& client) : peer(peer), client(client) {}

  // Main thread only:
  /// A file was edited, opened, closed or written to disk; refresh after `delay`.
  void changed(const Path& file, const ide::Snapshot& before, std::chrono::milliseconds delay);
  /// The meaning of all open texts may have changed.
  void allChanged(std::chrono::milliseconds delay);
  /// Severities have changed, or the findings of closed files have.
  void findingsChanged(std::chrono::milliseconds delay);
  /// When `refresh` must be called next.
  [[nodiscard]] std::optional<Time> due() const { return stopped ? std::nullopt : dueAt; }
  void refresh(const ide::Snapshot& now);
  /// Stops for good: a client that is leaving gets no more requests.
  void stop() { stopped = true; }

  // Any thread, immediate:
  void verdictsChanged() { ask({"workspace/diagnostic/refresh", "workspace/codeLens/refresh"}); }
  void hintsChanged() { ask({"workspace/inlayHint/refresh"}); }

private:
  void delayBy(std::chrono::milliseconds delay);
  [[nodiscard]] bool concernsOthers(const ide::Snapshot& now) const;
  void ask(std::initializer_list<const char*> methods);

  rpc::Peer& peer;
  const ClientFeatures& client;
  std::atomic<bool> stopped = false;
  std::optional<Time> dueAt;
  bool all = false;
  bool findings = false;
  std::set<Path> files;                            ///< changed since the last refresh
  std::shared_ptr<const ide::IncludeGraph> before; ///< the graph before the first of these changes
};

} // namespace proskill::lsp
