#pragma once

#include "lsp/inbox.h"
#include "lsp/outbox.h"
#include "lsp/pending.h"
#include "lsp/registry.h"
#include "lsp/statistics.h"
#include "lsp/verification.h"
#include "lsp/workspace.h"

#include <chrono>
#include <memory>
#include <string_view>

namespace proskill::lsp {

struct ServerOptions {
  std::string version;                    ///< told to the client
  unsigned threads = 3;                   ///< beside those that read and dispatch; at least 2
  std::chrono::milliseconds debounce{50}; ///< from the last edit to the diagnostics that are pushed
  std::function<void(std::string_view)> log; ///< a line each; from any thread
  /// What runs `runVerifyWorker`: by default this program.
  std::vector<std::string> worker{"/proc/self/exe", "verify-worker"};
};

/// The language server. Three kinds of threads: one reads the stream and cancels at once; the main
/// one applies edits in order and hands requests out; the pool answers them on snapshots.
class Server {
public:
  Server(Connection& connection, std::shared_ptr<const analysis::FileSystem> disk,
         ServerOptions options);

  /// Serves until `exit` or the end of the stream. 0 where the client asked for `shutdown` before,
  /// else 1.
  int run();

private:
  enum class Phase : std::uint8_t { Fresh, Running, ShutDown };
  using Time = std::chrono::steady_clock::time_point;

  void readStream();
  void receive(const Frame& frame);
  void receive(Message message);
  bool handle(Incident& incident);
  bool handleMessage(Received& received);
  void handleRequest(Received& received);
  bool handleNotification(const Message& message);
  void handleText(const Message& message);
  void handleWatchedFiles(const Json& params);
  void verdictsChanged();

  Json initialize(const Json& params);
  void initialized();
  void dispatch(Received& received, const Method& method);
  void answer(const Message& message, const Method& method, const ide::Snapshot& snapshot,
              const Cancellation& cancellation);
  void scheduleDiagnostics();
  void pushDiagnostics();
  void publish(const ide::Snapshot& snapshot, const std::filesystem::path& path,
               std::uint64_t asked);
  void failed(std::string_view method, const Json& params, const std::exception& error) const;
  Json status() const;
  void log(std::string_view line) const;
  void showError(std::string_view message);

  Connection& connection;
  ServerOptions options;
  Registry registry = allFeatures();
  Outbox outbox;
  Inbox inbox;
  Pending pending;
  Statistics statistics;
  Workspace workspace;
  ClientFeatures client;
  Phase phase = Phase::Fresh;
  std::vector<std::filesystem::path> folders;
  std::optional<Time> diagnosticsDue;
  unsigned lastRefresh = 0;                               ///< of the requests to the client
  std::map<std::filesystem::path, std::string> published; ///< paths with their client's URI
  std::atomic<std::uint64_t> revision{0};                 ///< of the texts
  std::mutex publishing; ///< between a look at the revision and the sending
  Verification verification;
  Scheduler longWork{3}; ///< verifications; both are last: their threads use all of the above
  Scheduler scheduler;
};

} // namespace proskill::lsp
