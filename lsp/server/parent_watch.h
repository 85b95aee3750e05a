#pragma once

#include "rpc/rpc.h"

#include <chrono>
#include <optional>

namespace proskill::lsp {

/// Watches the process that started the server, so that the server ends with it even where the
/// stream stays open. LSP 3.17, `InitializeParams.processId`.
class ParentWatch {
public:
  using Time = std::chrono::steady_clock::time_point;

  ParentWatch() = default; ///< watches nobody
  /// \param processId as `initialize` gives it; a number that means no process here is ignored: the
  /// client may run in a container or on the other end of a port
  explicit ParentWatch(const Json& processId);

  /// When to look next; nothing where nobody is watched.
  [[nodiscard]] std::optional<Time> due() const { return next; }
  /// Looks, where it is time to.
  [[nodiscard]] bool isGone();

private:
  int process = 0;
  std::optional<Time> next;
};

} // namespace proskill::lsp
