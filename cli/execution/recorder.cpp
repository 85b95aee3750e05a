#include "cli/execution/recorder.h"

#include <utility>

namespace proskill::cli {

namespace {

using std::chrono::steady_clock;

/// Limit of bytes that wait to be written.
constexpr std::size_t kMostWaiting = std::size_t{32} << 20;
/// In simulated time, this many bytes are written at once, or what there is after a short delay:
/// steps come so fast that separate writes would dominate.
constexpr std::size_t kBatch = std::size_t{64} << 10;
constexpr auto kMoment = std::chrono::milliseconds(100);
/// Interval at which the file is synchronised with the disk, to survive a power failure.
constexpr auto kSyncEvery = std::chrono::seconds(1);

} // namespace

Recorder::Recorder(disk::GrowingFile to, RunTime time)
    : file(std::move(to)), isReal(time == RunTime::Real) {}

Recorder::~Recorder() { std::ignore = finish(); }

std::optional<std::string> Recorder::add(std::string_view bytes, std::string_view last) {
  if (!thread.joinable()) return begin(bytes, last);
  Lock lock(mutex);
  if (!isReal)
    hasRoom.wait(lock, [&] { return isEnded || waiting.size() < kMostWaiting; });
  else if (waiting.size() >= kMostWaiting)
    stop("the disk does not keep up with the run");
  if (isEnded) return complaint();
  const auto size = waiting.size();
  waiting += bytes;
  sizes.push_back(static_cast<std::uint32_t>(bytes.size()));
  end = last;
  if (isReal ? size == 0 : size < kBatch && waiting.size() >= kBatch) hasBytes.notify_one();
  return std::nullopt;
}

std::optional<std::string> Recorder::begin(std::string_view bytes, std::string_view last) {
  auto wrong = file.add(bytes, last);
  isEnded = wrong.has_value();
  thread = std::thread([this] { run(); });
  return wrong;
}

std::optional<std::string> Recorder::finish() {
  {
    const Lock lock(mutex);
    isFinished = true;
    hasBytes.notify_one();
  }
  if (thread.joinable()) thread.join();
  return complaint();
}

std::optional<std::string> Recorder::complaint() { return std::exchange(failure, std::nullopt); }

void Recorder::stop(std::string why) {
  if (!isEnded) failure = std::move(why);
  isEnded = true;
  hasRoom.notify_one();
}

void Recorder::run() {
  Lock lock(mutex);
  while (!isEnded && !(isFinished && waiting.empty())) {
    awaitBytes(lock);
    if (!waiting.empty() && !isEnded) write(lock);
    if (!isSynced && steady_clock::now() - lastSync >= kSyncEvery) sync(lock);
  }
}

void Recorder::awaitBytes(Lock& lock) {
  const auto isEnough = [&] {
    return isFinished || isEnded || (isReal ? !waiting.empty() : waiting.size() >= kBatch);
  };
  if (!isReal)
    hasBytes.wait_for(lock, kMoment, isEnough);
  else if (isSynced)
    hasBytes.wait(lock, isEnough);
  else
    hasBytes.wait_until(lock, lastSync + kSyncEvery, isEnough);
}

void Recorder::write(Lock& lock) {
  std::swap(waiting, writing);
  std::swap(sizes, writingSizes);
  const auto last = end;
  lock.unlock();
  auto wrong = file.add(writing, last);
  if (wrong) wrong = addOneByOne(last);
  writing.clear();
  writingSizes.clear();
  lock.lock();
  if (wrong) return stop(*wrong);
  isSynced = !isReal;
  hasRoom.notify_one();
}

std::optional<std::string> Recorder::addOneByOne(std::string_view last) {
  std::string_view rest = writing;
  for (const auto size : writingSizes) {
    if (auto wrong = file.add(rest.substr(0, size), last)) return wrong;
    rest.remove_prefix(size);
  }
  return std::nullopt;
}

void Recorder::sync(Lock& lock) {
  lock.unlock();
  file.sync();
  lock.lock();
  isSynced = true;
  lastSync = steady_clock::now();
}

} // namespace proskill::cli
