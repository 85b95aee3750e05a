#pragma once

#include "rpc/rpc.h"
#include "rpc/scheduler.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <variant>

namespace proskill::rpc {

/// The client has disconnected.
struct EndOfStream {};
/// A message. A request has a cancellation token, which is valid from the moment it was read.
struct Received {
  Message message;
  Cancellation cancellation;
  std::uint64_t order = 0; ///< number of requests before it
};
/// A task prepared by another thread, to be finished on the main thread.
using Task = std::function<void()>;
using InboxEvent = std::variant<Received, MalformedMessage, Task, EndOfStream>;

/// Queue of the main thread: messages from the reading thread, in order.
class Inbox {
public:
  void put(InboxEvent event) {
    {
      std::lock_guard lock(mutex);
      queue.push_back(std::move(event));
    }
    wake.notify_one();
  }

  /// The next event; nothing at the deadline.
  std::optional<InboxEvent> take(std::optional<std::chrono::steady_clock::time_point> deadline) {
    std::unique_lock lock(mutex);
    auto ready = [&] { return !queue.empty(); };
    if (!deadline)
      wake.wait(lock, ready);
    else if (!wake.wait_until(lock, *deadline, ready))
      return std::nullopt;
    auto event = std::move(queue.front());
    queue.pop_front();
    return event;
  }

  /// The next event, if it has arrived and is wanted.
  template <class Wanted> std::optional<InboxEvent> takeIf(const Wanted& wanted) {
    const std::lock_guard lock(mutex);
    if (queue.empty() || !wanted(queue.front())) return std::nullopt;
    auto event = std::move(queue.front());
    queue.pop_front();
    return event;
  }

private:
  std::mutex mutex;
  std::condition_variable wake;
  std::deque<InboxEvent> queue;
};

} // namespace proskill::rpc
