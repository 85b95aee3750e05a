#pragma once

#include "lsp/rpc.h"
#include "lsp/scheduler.h"

#include <map>
#include <mutex>
#include <optional>

namespace proskill::lsp {

/// The requests that are not answered yet. Each is answered once: by its work, or by its
/// cancellation, whichever comes first.
class Pending {
public:
  /// The request's token; nothing where a request of the same identifier waits already.
  std::optional<Cancellation> begin(const Json& id) {
    std::lock_guard lock(mutex);
    auto [entry, isNew] = requests.try_emplace(id);
    return isNew ? std::optional(entry->second) : std::nullopt;
  }

  /// Whether the request still waits for an answer; the caller gives it.
  bool finish(const Json& id) {
    std::lock_guard lock(mutex);
    return requests.erase(id) > 0;
  }

  /// As `finish`, and tells the work that it is not needed.
  bool cancel(const Json& id) {
    std::lock_guard lock(mutex);
    auto found = requests.find(id);
    if (found == requests.end()) return false;
    found->second.cancel();
    requests.erase(found);
    return true;
  }

  /// At the end: nobody waits for anything any more.
  void cancelAll() {
    std::lock_guard lock(mutex);
    for (auto& [id, cancellation] : requests) cancellation.cancel();
    requests.clear();
  }

  [[nodiscard]] std::size_t size() const {
    std::lock_guard lock(mutex);
    return requests.size();
  }

private:
  mutable std::mutex mutex;
  std::map<Json, Cancellation> requests;
};

} // namespace proskill::lsp
