#pragma once

#include "rpc/rpc.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace proskill::lsp {

/// Progress of a running task. LSP 3.17, "Work Done Progress" and "Partial
/// Result Progress". If the client did not ask for it, nothing is sent.
class Progress {
public:
  using Notify = std::function<void(std::string_view method, const Json& params)>;

  Progress() = default;
  /// Tokens that are null were not given.
  Progress(Notify notify, Json workDoneToken, Json partialResultToken)
      : notify(std::move(notify)),
        workDone(std::move(workDoneToken)),
        partialResult(std::move(partialResultToken)) {}
  /// Ends a progress that has begun.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  [[nodiscard]] bool isWatched() const { return !workDone.is_null(); }
  void begin(std::string_view title, bool cancellable = true);
  /// \pre begun; `percentage` is at most 100 and never decreases
  void report(std::string_view message, std::optional<unsigned> percentage = std::nullopt);
  void end(std::string_view message = "");

  [[nodiscard]] bool wantsParts() const { return !partialResult.is_null(); }
  /// Sends a part of the result; the final answer contains only the rest. \pre `wantsParts()`
  void part(const Json& items) const { send(partialResult, items); }

private:
  void send(const Json& token, const Json& value) const {
    notify("$/progress", {{"token", token}, {"value", value}});
  }

  Notify notify;
  Json workDone;
  Json partialResult;
  bool begun = false;
};

} // namespace proskill::lsp
