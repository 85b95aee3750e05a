#include "dds/events.h"

#include <algorithm>

namespace proskill::dds {

void Events::add(Notice notice) {
  {
    const std::scoped_lock lock(mutex);
    const bool isKnown =
        notice.kind == DDS_MESSAGE && std::ranges::any_of(waiting, [&](const Notice& each) {
          return each.kind == DDS_MESSAGE && each.endpoint == notice.endpoint;
        });
    if (isKnown) return;
    waiting.push_back(std::move(notice));
  }
  changed.notify_one();
}

std::optional<Notice> Events::next(std::chrono::steady_clock::time_point until) {
  std::unique_lock lock(mutex);
  if (!changed.wait_until(lock, until, [this] { return !waiting.empty(); })) return std::nullopt;
  auto first = std::move(waiting.front());
  waiting.pop_front();
  return first;
}

} // namespace proskill::dds
