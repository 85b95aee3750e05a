#pragma once

#include "lsp/protocol/client.h"
#include "lsp/workspace/workspace.h"
#include "rpc/peer.h"
#include "rpc/scheduler.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>

namespace proskill::lsp {

/// Publishes in open platform files what is wrong with them. They are pushed to all clients: those
/// that pull diagnostics ask for those of programs only.
class PlatformPublisher {
public:
  using Time = std::chrono::steady_clock::time_point;
  using Snapshot = std::shared_ptr<const ide::Snapshot>;

  /// Takes the URI of a file whose diagnostics have failed, and the error; from any thread.
  using OnFailure = std::function<void(const std::string& uri, std::string_view error)>;

  /// The arguments outlive the publisher's tasks.
  PlatformPublisher(rpc::Peer& peer, rpc::Scheduler& scheduler, const ClientFeatures& client,
                    OnFailure onFailure)
      : peer(peer), scheduler(scheduler), client(client), onFailure(std::move(onFailure)) {}

  // Main thread only:
  /// Programs or platform files have changed; publish after `debounce`.
  void changed(std::chrono::milliseconds debounce);
  /// When `publish` must be called next.
  [[nodiscard]] std::optional<Time> due() const { return dueAt; }
  /// \param texts those that are open; empty: none is to have diagnostics
  void publish(const Snapshot& snapshot, const DataTexts& texts);

private:
  void retract(const DataTexts& texts);
  void compute(const ide::Snapshot& snapshot, const DataTexts& texts, std::uint64_t asked);
  void send(const DataText& text, Json found, std::uint64_t asked);

  rpc::Peer& peer;
  rpc::Scheduler& scheduler;
  const ClientFeatures& client;
  OnFailure onFailure;
  std::optional<Time> dueAt;
  std::atomic<std::uint64_t> revision{0};
  std::mutex mutex; ///< for what follows, and held between reading the revision and sending
  std::set<std::string> told; ///< URIs with diagnostics
};

} // namespace proskill::lsp
