#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace proskill::lsp {

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
  explicit Scheduler(unsigned threads);
  /// Waits for what runs, and drops what waits.
  ~Scheduler();
  Scheduler(const Scheduler&) = delete;
  Scheduler& operator=(const Scheduler&) = delete;

  void post(Priority priority, std::function<void()> task);

private:
  void work(bool interactiveOnly);
  bool take(bool interactiveOnly, std::function<void()>& task);

  std::mutex mutex;
  std::condition_variable wake;
  std::deque<std::function<void()>> interactive;
  std::deque<std::function<void()>> background;
  bool stopping = false;
  std::vector<std::jthread> threads;
};

} // namespace proskill::lsp
