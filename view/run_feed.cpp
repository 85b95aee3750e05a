#include "view/run_feed.h"

#include <algorithm>
#include <utility>

namespace proskill::view {

namespace {

using std::chrono::steady_clock;

/// Lines in the queue, which is emptied every moment.
constexpr std::size_t kQueued = 8192;
constexpr std::chrono::milliseconds kMoment{4};
/// Pages are notified no more often.
constexpr std::chrono::milliseconds kBetweenNews{50};
/// Of a longer run the beginning is forgotten; a recording has it.
constexpr std::size_t kMostKept = 100'000;
/// In one answer.
constexpr std::size_t kMostAtOnce = 2'000;

} // namespace

RunFeed::RunFeed(EventFeed& board, OrderedJson begin, bool mayWait, Status of)
    : news(board),
      waits(mayWait),
      status(std::move(of)),
      queue(kQueued),
      head(std::move(begin)),
      worker([this] { work(); }) {}

bool RunFeed::push(std::string_view line) {
  while (!queue.push([&](std::string& to) { to = line; })) {
    if (!waits) {
      ++lostLines;
      return false;
    }
    std::this_thread::sleep_for(kMoment);
  }
  wake();
  return true;
}

void RunFeed::finish() {
  finished = true;
  wake();
  if (worker.joinable()) worker.join();
}

void RunFeed::wake() {
  ++changes;
  changes.notify_one();
}

void RunFeed::work() {
  auto told = steady_clock::now() - kBetweenNews;
  bool isNew = false;
  for (std::uint32_t seen = 0; !finished;) {
    if (!isNew) changes.wait(seen);
    const auto now = changes.load();
    isNew = isNew || now != seen;
    seen = now;
    takeAll();
    if (isNew && steady_clock::now() - told >= kBetweenNews) {
      news.announce("run", status());
      told = steady_clock::now();
      isNew = false;
    } else if (isNew) {
      std::this_thread::sleep_for(kMoment);
    }
  }
  takeAll();
  news.announce("run", status());
}

void RunFeed::takeAll() {
  // copied, so that the queue keeps its memory
  std::string line;
  while (queue.pop([&](const std::string& it) { line = it; })) keep(line);
}

void RunFeed::keep(std::string line) {
  const std::lock_guard lock(mutex);
  kept.push_back(std::move(line));
  if (kept.size() > kMostKept) forgetFirst();
}

void RunFeed::forgetFirst() {
  const auto step = OrderedJson::parse(kept.front());
  for (const auto& change : step["changes"])
    head["initial"][change["variable"].get<std::string>()] = change["after"];
  kept.pop_front();
  ++first;
}

OrderedJson RunFeed::from(std::size_t index) const {
  std::vector<std::string> lines;
  OrderedJson answer = OrderedJson::object();
  {
    const std::lock_guard lock(mutex);
    const auto begin = std::clamp(index, first, first + kept.size());
    if (index < first) answer["initial"] = head["initial"];
    const auto count = std::min(kMostAtOnce, first + kept.size() - begin);
    const auto at = kept.begin() + static_cast<std::ptrdiff_t>(begin - first);
    lines.assign(at, at + static_cast<std::ptrdiff_t>(count));
    answer["from"] = begin;
    answer["total"] = first + kept.size();
  }
  answer["steps"] = OrderedJson::array();
  for (const auto& line : lines) answer["steps"].push_back(OrderedJson::parse(line));
  return answer;
}

OrderedJson RunFeed::trace() const {
  const std::lock_guard lock(mutex);
  auto whole = head;
  whole["steps"] = OrderedJson::array();
  for (const auto& line : kept) whole["steps"].push_back(OrderedJson::parse(line));
  return whole;
}

std::size_t RunFeed::total() const {
  const std::lock_guard lock(mutex);
  return first + kept.size();
}

} // namespace proskill::view
