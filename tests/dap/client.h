#pragma once

#include "process/child.h"
#include "rpc/framing.h"
#include "rpc/rpc.h"

#include <deque>
#include <functional>
#include <map>
#include <string>

namespace proskill::test {

/// The client of a debug adapter that runs as a process of its own.
class DapClient {
public:
  DapClient();

  /// The answer to a request; events that come before are kept.
  Json ask(const std::string& command, Json arguments = Json::object());
  /// The body of the answer to a request that succeeds.
  Json result(const std::string& command, Json arguments = Json::object());
  /// Sends and does not wait.
  int send(const std::string& command, Json arguments = Json::object());
  void sendRaw(const std::string& bytes);
  Json answer(int sequence);
  /// The body of the next event of that name.
  Json event(const std::string& name);
  /// Nothing comes any more: how the adapter ended.
  std::string ending();
  [[nodiscard]] int process() const { return child.id(); }

  /// Initialises, launches, and is done with the configuration; the first stop.
  Json start(const Json& launch);
  /// The top frame of the thread that a stop is in.
  Json top(const Json& stopped);
  /// Names and values of a scope of a frame.
  std::map<std::string, std::string> values(const Json& frame, const std::string& scope);

private:
  bool pump();
  Json waitFor(const std::function<bool(const Json&)>& isIt, const std::string& what);

  process::Child child;
  rpc::FrameReader frames;
  std::deque<Json> messages;
  std::string unsent;
  int last = 0;
  bool ended = false;
};

} // namespace proskill::test
