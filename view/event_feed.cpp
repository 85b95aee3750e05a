#include "view/panel_data.h"

#include <chrono>

namespace proskill::cli {

namespace {

/// A page that was asleep for longer sees the newest ones only, which tell the whole state.
constexpr std::size_t kMost = 64;
/// Then the page asks again, so that no connection is silent for too long.
constexpr std::chrono::seconds kLongestWait{20};

} // namespace

void EventFeed::announce(std::string method, Json params) {
  {
    const std::lock_guard lock(mutex);
    kept.push_back({{"method", std::move(method)}, {"params", std::move(params)}});
    if (kept.size() > kMost) kept.pop_front();
    ++count;
  }
  changed.notify_all();
}

EventFeed::Json EventFeed::after(std::size_t after) {
  std::unique_lock lock(mutex);
  changed.wait_for(lock, kLongestWait, [&] { return closed || count > after; });
  Json news = Json::array();
  const auto first = count - kept.size();
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (first + i >= after) news.push_back(kept[i]);
  return {{"next", count}, {"news", std::move(news)}};
}

void EventFeed::close() {
  {
    const std::lock_guard lock(mutex);
    closed = true;
  }
  changed.notify_all();
}

} // namespace proskill::cli
