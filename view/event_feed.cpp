#include "view/panel_data.h"

#include <utility>

namespace proskill::view {

namespace {

/// A page that was idle for longer receives only the newest events, which contain the whole state.
constexpr std::size_t kMost = 64;
/// After this time a request is answered anyway, so that no connection is idle for too long.
constexpr std::chrono::seconds kLongestWait{20};
/// Each waiting page needs a connection, and the number of descriptors is limited.
constexpr std::size_t kMostWaiting = 128;

} // namespace

void EventFeed::announce(std::string method, OrderedJson params) {
  {
    const std::lock_guard lock(mutex);
    kept.push_back({{"method", std::move(method)}, {"params", std::move(params)}});
    if (kept.size() > kMost) kept.pop_front();
    ++count;
  }
  changed.notify_all();
}

void EventFeed::after(std::size_t after, Tell tell) {
  {
    const std::lock_guard lock(mutex);
    const auto now = std::chrono::steady_clock::now();
    if (waiting.size() >= kMostWaiting) waiting.front().until = now;
    waiting.push_back({after, now + kLongestWait, std::move(tell)});
  }
  changed.notify_all();
}

/// Removes those whose wait is over.
std::vector<EventFeed::Waiting> EventFeed::takeDue(Time now) {
  std::vector<Waiting> due;
  std::erase_if(waiting, [&](Waiting& it) {
    const bool isDue = closed || count > it.after || it.until <= now;
    if (isDue) due.push_back(std::move(it));
    return isDue;
  });
  return due;
}

OrderedJson EventFeed::newsAfter(std::size_t after) const {
  OrderedJson news = OrderedJson::array();
  const auto first = count - kept.size();
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (first + i >= after) news.push_back(kept[i]);
  return {{"next", count}, {"news", std::move(news)}};
}

void EventFeed::tellAll() {
  std::unique_lock lock(mutex);
  while (true) {
    const auto due = takeDue(std::chrono::steady_clock::now());
    for (const auto& it : due) {
      auto news = newsAfter(it.after);
      lock.unlock();
      it.tell(std::move(news));
      lock.lock();
    }
    if (!due.empty()) continue;
    if (closed) return;
    if (waiting.empty())
      changed.wait(lock);
    else
      changed.wait_until(lock, waiting.front().until);
  }
}

void EventFeed::close() {
  {
    const std::lock_guard lock(mutex);
    closed = true;
  }
  changed.notify_all();
}

} // namespace proskill::view
