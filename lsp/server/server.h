#pragma once

#include "lsp/protocol/registry.h"
#include "lsp/server/announcer.h"
#include "lsp/server/client_folders.h"
#include "lsp/server/parent_watch.h"
#include "lsp/server/platform_publisher.h"
#include "lsp/server/publisher.h"
#include "lsp/server/refresher.h"
#include "lsp/server/server_log.h"
#include "lsp/server/settings_mistakes.h"
#include "lsp/server/statistics.h"
#include "lsp/verification/verification.h"
#include "lsp/workspace/notebooks.h"
#include "lsp/workspace/resynchronizer.h"
#include "lsp/workspace/workspace.h"
#include "rpc/inbox.h"
#include "rpc/outbox.h"
#include "rpc/peer.h"
#include "rpc/pending.h"

#include <chrono>
#include <memory>
#include <string_view>

namespace proskill::lsp {

/// Delay between the last edit and pushed diagnostics, if the last ones took noticeable time.
inline constexpr std::chrono::milliseconds kUsualDebounce{50};

struct ServerOptions {
  std::string version;  ///< sent to the client
  unsigned threads = 3; ///< in addition to those that read and dispatch; at least 2
  /// A longer one is used even if diagnostics are fast.
  std::chrono::milliseconds debounce = kUsualDebounce;
  std::function<void(std::string_view)> log{}; ///< one line each; from any thread
  std::filesystem::path manual{};              ///< page of diagnostics, for links; may be missing
  /// The command that runs `runVerifyWorker`; by default this program.
  std::vector<std::string> worker{"/proc/self/exe", "verify-worker"};
};

/// The language server. There are three kinds of threads: one reads the stream and cancels
/// immediately; the main thread applies edits in order and dispatches requests; the pool answers
/// them on snapshots.
class Server {
public:
  Server(rpc::Connection& connection, std::shared_ptr<const analysis::FileSystem> disk,
         ServerOptions options);

  /// Serves until `exit` or the end of the stream. Returns 0 if the client sent `shutdown` before,
  /// otherwise 1.
  int run();

private:
  enum class Phase : std::uint8_t { Fresh, Running, ShutDown };
  using Time = std::chrono::steady_clock::time_point;
  using Path = std::filesystem::path;

  void readStream();
  void receive(const rpc::Frame& frame);
  void receive(rpc::Message message);
  [[nodiscard]] std::optional<Time> nextDeadline() const;
  void onDeadline();
  bool handle(rpc::InboxEvent& event);
  bool handleMessage(rpc::Received& received);
  void handleRequest(rpc::Received& received);
  bool handleNotification(rpc::Received& received);
  void notified(rpc::Received& received);
  void dispatch(rpc::Received& received, const Method& method);
  [[nodiscard]] Answer execute(const Json& params);
  void answer(const rpc::Message& message, const Method& method, const Request& request);
  void reply(const rpc::Message& message, Answer result, Progress& progress);
  template <class Old> void forget(Old old);
  [[nodiscard]] std::chrono::milliseconds debounce();
  void verdictsChanged();
  void durationsMeasured();
  void findingsTold(const ide::Snapshot& snapshot);

  // server_texts.cpp
  void gatherEdits(rpc::Message& edit);
  void handleText(rpc::Received& received);
  void handleData(const rpc::Message& message);
  void handleNotebook(const rpc::Received& received);
  void textsChanged(const std::vector<Path>& texts, std::shared_ptr<const ide::Snapshot> before);
  void textsChanged();
  void changed();
  void refuseStale(const std::string& uri, std::uint64_t order);
  void synchronized(const rpc::Message& message);
  [[nodiscard]] const InexactText* lostTextFor(const rpc::Message& request) const;
  void refuseLost(const rpc::Message& request, const InexactText& lost);

  // server_lifecycle.cpp
  Json initialize(const Json& params);
  void initialized();
  void askForSettings();
  void setSettings(const Json& settings);
  void changeFolders(const Json& params);
  void foldersRead();
  void handleWatchedFiles(const Json& params);
  void filesChanged(const std::vector<Path>& paths, const ide::Snapshot& before);

  [[nodiscard]] Json status(const ide::Snapshot& snapshot) const;

  rpc::Connection& connection;
  ServerOptions options;
  Registry registry = allFeatures();
  rpc::Outbox outbox;
  rpc::Peer peer;
  ServerLog log;
  Announcer announcer;
  rpc::Inbox inbox;
  rpc::Pending pending;
  Statistics statistics;
  Workspace workspace;
  Notebooks notebooks{workspace};
  ClientFeatures client;
  std::shared_ptr<const ClientSettings> settings = std::make_shared<const ClientSettings>();
  Phase phase = Phase::Fresh;
  SettingsMistakes mistakes{peer, client};
  ParentWatch parent;
  Time started = std::chrono::steady_clock::now();
  std::atomic<std::uint64_t> errors{0}; ///< requests that failed because of a bug
  std::atomic<int> forgotten{0}; ///< number of old texts and programs that wait for destruction
  Verification verification;
  Publisher publisher;
  PlatformPublisher platforms{
      peer, scheduler, client, [this](const std::string& uri, std::string_view error) {
        log.writeFailure("textDocument/publishDiagnostics", {{"uri", uri}}, error);
      }};
  Refresher refresher{peer, client};
  Resynchronizer resynchronizer{peer, client};
  ClientFolders folders{{workspace, peer, client, inbox, scheduler, [this] { foldersRead(); }}};
  // The last members, because their threads use all of the above.
  rpc::Scheduler longWork{3}; ///< verifications
  rpc::Scheduler scheduler;
};

/// Destroys old texts, which may include whole programs. Not on this thread, where an answer or the
/// next edit would wait for it, unless edits come faster than the texts can be destroyed.
template <class Old> void Server::forget(Old old) {
  constexpr int kMostForgotten = 3;
  if (forgotten.load() >= kMostForgotten) return;
  ++forgotten;
  scheduler.post(rpc::Priority::Background, [this, old = std::move(old)]() mutable {
    scheduler.giveWay();
    old = Old();
    --forgotten;
  });
}

} // namespace proskill::lsp
