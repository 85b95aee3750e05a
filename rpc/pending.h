#pragma once

#include "rpc/rpc.h"
#include "rpc/scheduler.h"

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace proskill::rpc {

/// Requests without an answer so far. Each is answered once: by its task, or by its
/// cancellation, whichever comes first.
class Pending {
public:
  /// The request's token; nothing if a request with the same identifier is pending.
  std::optional<Cancellation> begin(const Message& message) {
    const Json& uri = memberAt(message.params, {"textDocument", "uri"});
    Waiting waiting{{}, message.method, uri.is_string() ? uri.get<std::string>() : std::string()};
    const std::lock_guard lock(mutex);
    waiting.order = begun++;
    auto [entry, isNew] = requests.try_emplace(message.id, std::move(waiting));
    return isNew ? std::optional(entry->second.cancellation) : std::nullopt;
  }

  /// Whether the request still waits for an answer; the caller gives it.
  bool finish(const Json& id) {
    const std::lock_guard lock(mutex);
    return requests.erase(id) > 0;
  }

  /// As `finish`, and cancels the task.
  bool cancel(const Json& id) {
    const std::lock_guard lock(mutex);
    auto found = requests.find(id);
    if (found == requests.end()) return false;
    found->second.cancellation.cancel();
    requests.erase(found);
    return true;
  }

  struct Request {
    Json id;
    std::string method;
  };
  /// Those of these methods that ask about a text, by its URI, among the first `before` that came.
  template <class Methods>
  [[nodiscard]] std::vector<Request> about(const std::string& uri, const Methods& methods,
                                           std::uint64_t before) const {
    const std::lock_guard lock(mutex);
    std::vector<Request> result;
    for (const auto& [id, waiting] : requests)
      if (waiting.order < before && waiting.uri == uri && methods.contains(waiting.method))
        result.push_back({id, waiting.method});
    return result;
  }

  /// At the end: cancels all.
  void cancelAll() {
    const std::lock_guard lock(mutex);
    for (auto& [id, waiting] : requests) waiting.cancellation.cancel();
    requests.clear();
  }

  /// How many requests have come so far.
  [[nodiscard]] std::uint64_t count() const {
    const std::lock_guard lock(mutex);
    return begun;
  }

  [[nodiscard]] std::size_t size() const {
    const std::lock_guard lock(mutex);
    return requests.size();
  }

private:
  struct Waiting {
    Cancellation cancellation;
    std::string method;
    std::string uri; ///< of its text document; empty where it has none
    std::uint64_t order = 0;
  };

  mutable std::mutex mutex;
  std::map<Json, Waiting> requests;
  std::uint64_t begun = 0;
};

} // namespace proskill::rpc
