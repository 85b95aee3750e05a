#pragma once

#include "lsp/inbox.h"
#include "lsp/outbox.h"
#include "lsp/pending.h"
#include "lsp/registry.h"
#include "lsp/statistics.h"
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
  bool handle(Incident& incident);
  bool handleMessage(Message& message);
  void handleRequest(Message& message);
  bool handleNotification(const Message& message);
  void handleText(const Message& message);
  void handleWatchedFiles(const Json& params);

  Json initialize(const Json& params);
  void initialized();
  void dispatch(Message& message, const Method& method);
  void answer(const Message& message, const Method& method, const ide::Snapshot& snapshot,
              const Cancellation& cancellation);
  void scheduleDiagnostics();
  void pushDiagnostics();
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
  std::map<std::filesystem::path, std::string> published; ///< paths with their client's URI
  std::atomic<std::uint64_t> revision{0};                 ///< of the texts
  Scheduler scheduler; ///< last: its threads use all of the above
};

} // namespace proskill::lsp
