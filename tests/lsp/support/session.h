#pragma once

#include "lsp/server/server.h"
#include "tests/support/memory_files.h"
#include "tests/where.h"

#include <condition_variable>
#include <deque>
#include <future>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace proskill::test {

/// The server's end of a stream in memory.
class Pipe : public rpc::Connection {
public:
  [[nodiscard]] std::string read() override;
  bool write(std::string_view bytes) override;
  void close() override;

  /// The client's end.
  void send(std::string bytes);
  void hangUp();
  /// The next message of the server; fails the test if there is none.
  [[nodiscard]] Json receive();
  /// Whether a message is waiting.
  [[nodiscard]] bool hasMore();

private:
  std::mutex mutex;
  std::condition_variable wake;
  std::deque<std::string> toServer;
  std::deque<Json> toClient;
  rpc::FrameReader frames;
  bool closed = false;
};

/// A server in this process, with its client.
class Session {
public:
  struct Options {
    std::shared_ptr<const analysis::FileSystem> disk = std::make_shared<MemoryFiles>();
    std::string encoding = "utf-16";
    bool pull = false;                  ///< the client pulls diagnostics
    Json capabilities = Json::object(); ///< beside the usual ones
    std::chrono::milliseconds debounce{0};
    std::vector<std::string> retried{}; ///< methods that the client repeats after an edit
    /// Nothing is verified unless a test requests it.
    Json initializationOptions = {{"verify", {{"live", false}, {"delay", 3'600'000}}}};
    std::vector<std::string> worker{PROSKILL_PROGRAM, "verify-worker"};
  };

  Session() : Session(Options()) {}
  explicit Session(Options options);
  /// Closes the connection if the server still runs.
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void initialize();
  void sendRaw(std::string bytes) { pipe.send(std::move(bytes)); }
  void sendBody(std::string_view body) { pipe.send(rpc::frame(body)); }
  void notify(std::string_view method, const Json& params);
  /// Sends a request, and returns its identifier.
  int send(std::string_view method, const Json& params);
  /// The whole response to a request. Earlier notifications are kept.
  Json answer(int id);
  Json ask(std::string_view method, const Json& params) { return answer(send(method, params)); }
  /// The result of a successful request.
  Json result(std::string_view method, const Json& params);
  /// The next notification of this method.
  Json notified(std::string_view method);
  /// Whether such a notification was received, and not returned yet.
  [[nodiscard]] bool wasNotified(std::string_view method) const;
  /// The next message of any kind.
  Json receive() { return pipe.receive(); }
  [[nodiscard]] bool hasMore() { return pipe.hasMore(); }
  void hangUp() { pipe.hangUp(); }
  /// The server's exit code, after it has ended.
  int exitCode() { return running.get(); }

  void open(const std::string& uri, const std::string& text, int version = 1);
  /// Replaces the text between two positions, each given as line and column.
  void change(const std::string& uri, int version, Json range, const std::string& text);
  void close(const std::string& uri);
  /// `result` of a request with a position.
  Json at(std::string_view method, const std::string& uri, unsigned line, unsigned character,
          Json more = Json::object());

private:
  Options options;
  Pipe pipe;
  lsp::Server server;
  std::future<int> running;
  std::deque<Json> notifications;
  int lastId = 0;
};

[[nodiscard]] Json rangeOf(unsigned line, unsigned from, unsigned to);

} // namespace proskill::test
