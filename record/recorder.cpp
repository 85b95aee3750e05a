#include "record/recorder.h"

#include <algorithm>
#include <poll.h>
#include <utility>

namespace proskill::record {

namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// Limit of bytes that wait to be written.
constexpr std::size_t kMostWaiting = std::size_t{32} << 20;
/// Larger additions are divided.
constexpr std::size_t kLargest = std::size_t{1} << 20;
/// In simulated time, this many bytes are written at once, or what there is after a short delay:
/// steps come so fast that separate writes would dominate.
constexpr std::size_t kBatch = std::size_t{64} << 10;
constexpr milliseconds kMoment(100);
/// Time between two writes in real time, unless much waits: waking a thread for each step would
/// cost more than the rest of the step. After a longer pause a step is written at once.
constexpr milliseconds kBetweenWrites(50);
constexpr std::size_t kMuch = std::size_t{1} << 20;
/// Interval at which the file is synchronised with the disk, to survive a power failure.
constexpr milliseconds kSyncEvery(1'000);

milliseconds until(steady_clock::time_point date) {
  return std::max(std::chrono::ceil<milliseconds>(date - steady_clock::now()), milliseconds(0));
}

} // namespace

void Sleeper::wait(milliseconds patience) const {
  pollfd watched{bell.descriptor(), POLLIN, 0};
  ::poll(&watched, 1, static_cast<int>(patience.count()));
}

Recorder::Recorder(disk::GrowingFile to, RunTime time)
    : file(std::move(to)), isReal(time == RunTime::Real), queue(kMostWaiting) {}

Recorder::~Recorder() { std::ignore = finish(); }

std::optional<std::string> Recorder::add(std::string_view bytes, std::string_view last) {
  if (!thread.joinable()) return begin(bytes, last);
  for (; bytes.size() > kLargest; bytes.remove_prefix(kLargest))
    if (auto wrong = put({.last = {}}, bytes.substr(0, kLargest))) return wrong;
  return put({.last = last}, bytes);
}

std::optional<std::string> Recorder::replace(std::uint64_t at, std::string_view bytes) {
  return put({.replaces = true, .at = at}, bytes);
}

std::optional<std::string> Recorder::put(const Order& order, std::string_view bytes) {
  if (isReported) return std::nullopt;
  const auto isOver = [&] { return isEnded.load(std::memory_order_acquire); };
  while (!isOver() && !queue.push(order, bytes)) {
    if (isReal) {
      isReported = true;
      return "the disk does not keep up with the run";
    }
    adder.sleep(kMoment, [&] { return isOver() || queue.used() < kMostWaiting / 2; });
  }
  if (isOver()) return complaint();
  const auto waiting = queue.used();
  if (isReal || waiting >= kBatch) writer.wake();
  if (waiting >= kMuch) pause.wake();
  return std::nullopt;
}

std::optional<std::string> Recorder::begin(std::string_view bytes, std::string_view last) {
  auto wrong = file.add(bytes, last);
  isEnded = isReported = wrong.has_value();
  thread = std::thread([this] { run(); });
  return wrong;
}

std::optional<std::string> Recorder::finish() {
  isFinished = true;
  writer.wake();
  pause.wake();
  if (thread.joinable()) thread.join();
  return isEnded ? complaint() : std::nullopt;
}

std::optional<std::string> Recorder::complaint() {
  if (std::exchange(isReported, true)) return std::nullopt;
  return failure;
}

void Recorder::run() {
  while (!isEnded) {
    const bool isLast = isFinished; // before the last look at the queue
    writeAll();
    if (isLast) return;
    if (!isSynced && until(lastSync + kSyncEvery) == milliseconds(0)) sync();
    rest();
  }
}

/// Sleeps until there is something to write, or to hand to the disk.
void Recorder::rest() {
  const auto isOver = [&] { return isFinished.load(); };
  if (!isReal) return writer.sleep(kMoment, [&] { return isOver() || queue.used() >= kBatch; });
  pause.sleep(kBetweenWrites, [&] { return isOver() || queue.used() >= kMuch; });
  const auto patience = isSynced ? milliseconds(-1) : until(lastSync + kSyncEvery);
  writer.sleep(patience, [&] { return isOver() || queue.used() > 0; });
}

void Recorder::writeAll() {
  const auto take = [&](const Order& order, std::string_view bytes) {
    if (order.replaces) {
      write();
      if (!isEnded) file.replace(order.at, bytes);
      return;
    }
    writing += bytes;
    sizes.push_back(static_cast<std::uint32_t>(bytes.size()));
    end = order.last;
    if (writing.size() >= kLargest) write();
  };
  while (!isEnded && queue.pop(take)) {
  }
  write();
}

void Recorder::write() {
  if (writing.empty() || isEnded) return;
  auto wrong = file.add(writing, end);
  if (wrong) wrong = addOneByOne();
  writing.clear();
  sizes.clear();
  if (wrong) {
    failure = std::move(*wrong);
    isEnded.store(true, std::memory_order_release);
  }
  isSynced = !isReal;
  adder.wake();
}

/// Adds what fits of that for which there was no room.
std::optional<std::string> Recorder::addOneByOne() {
  std::string_view rest = writing;
  for (const auto size : sizes) {
    if (auto wrong = file.add(rest.substr(0, size), end)) return wrong;
    rest.remove_prefix(size);
  }
  return std::nullopt;
}

void Recorder::sync() {
  file.sync();
  isSynced = true;
  lastSync = steady_clock::now();
}

} // namespace proskill::record
