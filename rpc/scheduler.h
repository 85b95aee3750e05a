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

/// Cooperative cancellation of a task. Copies refer to the same task.
class Cancellation {
public:
  void cancel() { flag->store(true); }
  [[nodiscard]] bool isCancelled() const { return flag->load(); }
  /// The flag itself, for functions that take a plain flag.
  [[nodiscard]] const std::atomic<bool>& raw() const { return *flag; }

private:
  std::shared_ptr<std::atomic<bool>> flag = std::make_shared<std::atomic<bool>>(false);
};

/// Tasks that a user waits for have priority over background tasks. Tasks that take minutes, such
/// as a verification, must not run on the scheduler that answers requests.
enum class Priority : std::uint8_t { Interactive, Background, Long };

/// A thread pool. One of its threads runs only interactive tasks, so that these never wait
/// for a long background task.
class Scheduler {
public:
  /// \pre threads >= 2
  /// \param patience the maximal time for which background tasks give way
  explicit Scheduler(unsigned threads,
                     std::chrono::milliseconds patience = std::chrono::milliseconds(20));
  /// Waits for running tasks, and drops pending ones.
  ~Scheduler();
  Scheduler(const Scheduler&) = delete;
  Scheduler& operator=(const Scheduler&) = delete;

  void post(Priority priority, std::function<void()> task);
  /// For background tasks, at a point where they hold no locks: waits until there are no
  /// interactive tasks, at most for the patience.
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
