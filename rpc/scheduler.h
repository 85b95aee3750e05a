#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace proskill::rpc {

/// Says to a piece of work that nobody waits for it any more. Copies speak of the same work.
class Cancellation {
public:
  void cancel() { flag->store(true); }
  [[nodiscard]] bool isCancelled() const { return flag->load(); }
  /// For work that takes a plain flag.
  [[nodiscard]] const std::atomic<bool>& raw() const { return *flag; }

private:
  std::shared_ptr<std::atomic<bool>> flag = std::make_shared<std::atomic<bool>>(false);
};

/// What somebody waits for goes before what nobody sees. What may take minutes, as a verification,
/// is not for the scheduler that answers the rest.
enum class Priority : std::uint8_t { Interactive, Background, Long };

/// A few threads that run what they are given. One of them takes nothing but interactive work, so
/// that this never waits for a long background task.
class Scheduler {
public:
  /// \pre threads >= 2
  /// \param patience how long background work gives way at most
  explicit Scheduler(unsigned threads,
                     std::chrono::milliseconds patience = std::chrono::milliseconds(20));
  /// Waits for what runs, and drops what waits.
  ~Scheduler();
  Scheduler(const Scheduler&) = delete;
  Scheduler& operator=(const Scheduler&) = delete;

  void post(Priority priority, std::function<void()> task);
  /// For background work, where it holds nothing that others want: waits until nobody waits for an
  /// answer, or the patience ends.
  void giveWay();

private:
  /// \pre the mutex is held
  [[nodiscard]] bool isQuiet() const { return interactive.empty() && interactiveRuns == 0; }
  void work(bool interactiveOnly);
  std::optional<Priority> take(bool interactiveOnly, std::function<void()>& task);
  void finished(Priority priority);

  const std::chrono::milliseconds patience;
  std::mutex mutex;
  std::condition_variable wake;
  std::condition_variable quiet;
  unsigned interactiveRuns = 0;
  std::deque<std::function<void()>> interactive;
  std::deque<std::function<void()>> background;
  bool stopping = false;
  std::vector<std::jthread> threads;
};

} // namespace proskill::rpc
