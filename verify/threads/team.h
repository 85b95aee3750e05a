#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace proskill::verify {

/// Threads that do one task after another together.
class Team {
public:
  using Task = std::function<void(std::size_t)>; ///< receives the number of the thread

  /// \param members number of threads, with the calling one: at least 1; fewer if the system has no
  /// more
  explicit Team(std::size_t members);
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  ~Team();

  /// Calls `task` in all threads, in the calling one with 0, and waits until each of them is done.
  /// \throw what one of them has thrown
  void inAll(Task task);
  [[nodiscard]] std::size_t size() const { return threads.size() + 1; }

private:
  void serve(std::size_t member, const std::stop_token& stop);
  void attempt(std::size_t member);

  Task current;
  std::atomic<std::uint64_t> round{0}; ///< number of tasks so far
  std::atomic<std::size_t> busy{0};    ///< number of other threads that still work at the task
  std::mutex guard;
  std::exception_ptr failure; ///< thrown by one of them
  std::vector<std::jthread> threads;
};

} // namespace proskill::verify
