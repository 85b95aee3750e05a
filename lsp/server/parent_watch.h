#pragma once

#include "rpc/rpc.h"

#include <chrono>
#include <optional>

namespace proskill::lsp {

/// Watches the process that started the server, so that the server ends with it even if the stream
/// stays open. LSP 3.17, `InitializeParams.processId`.
class ParentWatch {
public:
  using Time = std::chrono::steady_clock::time_point;

  ParentWatch() = default; ///< watches nobody
  /// \param processId from `initialize`. A number that is not a process here is ignored: the client
  /// may run in a container or on the other end of a port.
  explicit ParentWatch(const Json& processId);

  /// When to check next; nothing if no process is watched.
  [[nodiscard]] std::optional<Time> due() const { return next; }
  /// Whether the process has ended; checks only when it is due.
  [[nodiscard]] bool isGone();

private:
  int process = 0;
  std::optional<Time> next;
};

} // namespace proskill::lsp
