#pragma once

#include "process/child.h"
#include "rpc/framing.h"
#include "rpc/rpc.h"

#include <deque>
#include <functional>
#include <map>
#include <string>

namespace proskill::test {

/// Client of a debug adapter that runs as a separate process.
class DapClient {
public:
  DapClient();

  /// The response to a request; earlier events are kept.
  Json ask(const std::string& command, Json arguments = Json::object());
  /// The body of the response to a successful request.
  Json result(const std::string& command, Json arguments = Json::object());
  /// Sends a request without waiting.
  int send(const std::string& command, Json arguments = Json::object());
  void sendRaw(const std::string& bytes);
  Json answer(int sequence);
  /// The body of the next event with this name.
  Json event(const std::string& name);
  /// Whether the console has shown these words before the last answer.
  [[nodiscard]] bool said(std::string_view words) const;
  /// Waits for the end of the output. Returns how the adapter ended.
  std::string ending();
  [[nodiscard]] int process() const { return child.id(); }

  /// Initialises, launches, ends the configuration, and waits for the first stop.
  Json start(const Json& launch);
  /// The top frame of the thread that has stopped.
  Json top(const Json& stopped);
  /// Names and values in a scope of a frame.
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
