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

/// Requests that have not been answered. Each is answered once, by its task or by its cancellation,
/// whichever comes first.
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

  /// Whether the request is still unanswered; if so, the caller must answer it.
  bool finish(const Json& id) {
    const std::lock_guard lock(mutex);
    return requests.erase(id) > 0;
  }

  /// Like `finish`, and cancels the task.
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
  /// The pending requests with these methods about a text, among the first `before` requests.
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

  /// Cancels all requests, at the end.
  void cancelAll() {
    const std::lock_guard lock(mutex);
    for (auto& [id, waiting] : requests) waiting.cancellation.cancel();
    requests.clear();
  }

  /// The number of requests so far.
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
    std::string uri; ///< of its text document; empty if it has none
    std::uint64_t order = 0;
  };

  mutable std::mutex mutex;
  std::map<Json, Waiting> requests;
  std::uint64_t begun = 0;
};

} // namespace proskill::rpc
