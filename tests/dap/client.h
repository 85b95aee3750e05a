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
  lsp::Json ask(const std::string& command, lsp::Json arguments = lsp::Json::object());
  /// The body of the answer to a request that succeeds.
  lsp::Json result(const std::string& command, lsp::Json arguments = lsp::Json::object());
  /// Sends and does not wait.
  int send(const std::string& command, lsp::Json arguments = lsp::Json::object());
  void sendRaw(const std::string& bytes);
  lsp::Json answer(int sequence);
  /// The body of the next event of that name.
  lsp::Json event(const std::string& name);
  /// Nothing comes any more: how the adapter ended.
  std::string ending();
  [[nodiscard]] int process() const { return child.id(); }

  /// Initialises, launches, and is done with the configuration; the first stop.
  lsp::Json start(const lsp::Json& launch);
  /// The top frame of the thread that a stop is in.
  lsp::Json top(const lsp::Json& stopped);
  /// Names and values of a scope of a frame.
  std::map<std::string, std::string> values(const lsp::Json& frame, const std::string& scope);

private:
  bool pump();
  lsp::Json waitFor(const std::function<bool(const lsp::Json&)>& isIt, const std::string& what);

  process::Child child;
  lsp::FrameReader frames;
  std::deque<lsp::Json> messages;
  std::string unsent;
  int last = 0;
  bool ended = false;
};

} // namespace proskill::test
