#pragma once

#include "dap/launch.h"
#include "dap/player.h"

#include "rpc/connection.h"
#include "rpc/framing.h"
#include "rpc/outbox.h"

#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>

namespace proskill::dap {

struct AdapterOptions {
  std::string version;
  std::vector<std::string> worker{"/proc/self/exe", "verify-worker"};
};

/// A debug adapter for a trace or a simulation. Debug Adapter Protocol 1.65; docs/dap.md describes
/// our extensions. A separate thread reads, so that a verification can be cancelled.
class Adapter {
public:
  Adapter(rpc::Connection& connection, const analysis::FileSystem& disk, AdapterOptions options);

  /// Serves until the client disconnects (returns 0) or the connection breaks (returns 1).
  int run();

private:
  using Answer = std::expected<Json, std::string>;
  using Handler = Answer (Adapter::*)(const Json& arguments);

  void readStream();
  std::optional<Json> take();
  void handle(const Json& message);
  void afterwards(const std::string& command);

  Answer initialize(const Json& arguments);
  Answer launch(const Json& arguments);
  Answer configurationDone(const Json& arguments);
  Answer disconnect(const Json& arguments);
  Answer setBreakpoints(const Json& arguments);
  Answer setNothing(const Json& arguments);
  Answer dataBreakpointInfo(const Json& arguments);
  Answer setDataBreakpoints(const Json& arguments);
  Answer threads(const Json& arguments);
  Answer stackTrace(const Json& arguments);
  Answer scopes(const Json& arguments);
  Answer variables(const Json& arguments);
  Answer evaluate(const Json& arguments);
  Answer next(const Json& arguments);
  Answer stepIn(const Json& arguments);
  Answer stepOut(const Json& arguments);
  Answer stepBack(const Json& arguments);
  Answer resume(const Json& arguments);
  Answer reverseContinue(const Json& arguments);
  Answer pause(const Json& arguments);
  Answer restart(const Json& arguments);
  Answer stepInTargets(const Json& arguments);
  Answer choices(const Json& arguments);
  Answer choose(const Json& arguments);
  Answer position(const Json& arguments);
  Answer goTo(const Json& arguments);

  static const std::map<std::string, Handler, std::less<>>& handlers();

  void send(Json message);
  void event(std::string_view name, Json body);
  void stopped(Stop why, std::string_view plain);
  void console(const std::string& text);
  [[nodiscard]] Json frame(long long id, const std::string& name,
                           const std::optional<Place>& place) const;
  [[nodiscard]] Json choiceJson(std::size_t i) const;
  [[nodiscard]] long long threadOf(const std::string& actor) const;
  [[nodiscard]] const std::string* actorOf(const Json& arguments) const;
  [[nodiscard]] unsigned line(unsigned fromOne) const { return fromOne - (linesFromOne ? 0 : 1); }
  [[nodiscard]] unsigned column(unsigned fromOne) const {
    return fromOne - (columnsFromOne ? 0 : 1);
  }

  rpc::Connection& connection;
  const analysis::FileSystem& disk;
  AdapterOptions options;
  rpc::Outbox outbox;
  long long lastSent = 0;

  std::mutex mutex; ///< of the queue
  std::condition_variable wake;
  std::deque<Json> queue;
  bool streamEnded = false;
  rpc::Cancellation cancellation; ///< for the work of `launch`

  bool linesFromOne = true;
  bool columnsFromOne = true;
  bool showsProgress = false;
  bool configured = false; ///< `configurationDone` has been received
  bool announced = false;  ///< the first stop was reported
  bool finished = false;
  LaunchArguments launched;
  std::unique_ptr<Player> player; ///< null until `launch` has succeeded
  std::optional<Stop> stop;       ///< to be reported after the answer
  std::string stopWords;
};

} // namespace proskill::dap
