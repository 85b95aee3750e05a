#pragma once

#include "rpc/peer.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <string_view>

namespace proskill::lsp {

/// The server's log, and `$/logTrace` as far as the client wants it. Thread-safe.
class ServerLog {
public:
  using Sink = std::function<void(std::string_view line)>;

  /// \param sink may be empty: nothing is logged then
  ServerLog(Sink sink, rpc::Peer& peer) : sink(std::move(sink)), peer(peer) {}

  /// `off`, `messages` or `verbose`; other values are ignored. LSP 3.17, `TraceValue`.
  void setTrace(const Json& value);

  void write(std::string_view line) const;
  void writeAnswer(const rpc::Message& message, std::string_view outcome,
                   std::chrono::nanoseconds latency);
  void writeFailure(std::string_view method, const Json& params, std::string_view error) const;

private:
  enum class Trace : std::uint8_t { Off, Messages, Verbose };

  Sink sink;
  rpc::Peer& peer;
  std::atomic<Trace> trace = Trace::Off;
};

} // namespace proskill::lsp
