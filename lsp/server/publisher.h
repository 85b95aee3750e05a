#pragma once

#include "ide/verdicts/verdicts.h"
#include "lsp/protocol/client.h"
#include "lsp/server/pace.h"
#include "lsp/server/statistics.h"
#include "lsp/workspace/workspace.h"
#include "rpc/peer.h"
#include "rpc/scheduler.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace proskill::lsp {

/// Publishes the diagnostics of open texts after a delay without edits.
/// A newer edit cancels a computation and drops its result; unchanged diagnostics
/// are not sent again.
class Publisher {
public:
  using Time = std::chrono::steady_clock::time_point;
  using GetVerdicts = std::function<std::shared_ptr<const ide::Verdicts>()>;
  using OnPublished = std::function<void(const ide::Snapshot& snapshot)>;
  using OnFailure =
      std::function<void(std::string_view method, const Json& params, std::string_view error)>;

  /// All arguments must outlive the publisher's tasks.
  Publisher(rpc::Peer& peer, rpc::Scheduler& scheduler, Statistics& statistics,
            const ClientFeatures& client, GetVerdicts verdicts, OnPublished onPublished,
            OnFailure onFailure)
      : peer(peer),
        scheduler(scheduler),
        statistics(statistics),
        client(client),
        verdicts(std::move(verdicts)),
        onPublished(std::move(onPublished)),
        onFailure(std::move(onFailure)) {}

  /// Main thread only: texts or settings have changed; publish after `debounce`.
  void changed(std::chrono::milliseconds debounce);
  /// Whether the last diagnostics of all texts took so little time that the next need not wait.
  [[nodiscard]] bool isQuick();
  /// When `publish` must be called next.
  [[nodiscard]] std::optional<Time> due() const { return dueAt; }
  /// Main thread only: a text was lost; what its diagnostics are is now said by others.
  void leave(const std::filesystem::path& path);
  /// Main thread only. \param enabled false: removes published diagnostics
  void publish(const std::shared_ptr<const ide::Snapshot>& snapshot, bool enabled);

private:
  using Path = std::filesystem::path;
  using Owners = std::vector<std::weak_ptr<const ide::AnalysedProgram>>;

  /// The last published diagnostics of a text.
  struct Told {
    std::string uri;
    std::int64_t version = 0;
    Owners owners;                                 ///< the programs that contain it
    std::shared_ptr<const ide::Verdicts> verdicts; ///< published together with it
    bool sent = false;
  };

  void retract(const ide::Snapshot& snapshot, bool enabled);
  void publishLatest(const Path& path, std::uint64_t asked);
  void publish(const ide::Snapshot& snapshot, const Path& path, std::uint64_t asked);
  void finish(std::uint64_t asked, Pace::Duration took);
  [[nodiscard]] bool isTold(const Path& path, const Told& now);

  rpc::Peer& peer;
  rpc::Scheduler& scheduler;
  Statistics& statistics;
  const ClientFeatures& client;
  GetVerdicts verdicts;
  OnPublished onPublished; ///< called by any thread when the findings of a text have been published
  OnFailure onFailure;
  std::optional<Time> dueAt;
  std::atomic<std::uint64_t> revision{0}; ///< of the texts
  rpc::Cancellation running;              ///< tasks of the last revision
  std::mutex mutex; ///< for the members below, and held between reading the revision and sending
  std::map<Path, Told> told;
  Pace pace;
  std::shared_ptr<const ide::Snapshot> latest; ///< to be published; null if it is outdated
};

} // namespace proskill::lsp
