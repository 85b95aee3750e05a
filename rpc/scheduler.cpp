#include "rpc/scheduler.h"

#include <cassert>

namespace proskill::rpc {

Scheduler::Scheduler(unsigned count, std::chrono::milliseconds patience) : patience(patience) {
  assert(count >= 2);
  for (unsigned i = 0; i < count; ++i) threads.emplace_back([this, i] { work(i == 0); });
}

Scheduler::~Scheduler() {
  {
    std::lock_guard lock(mutex);
    stopping = true;
    interactive.clear();
    background.clear();
  }
  wake.notify_all();
  quiet.notify_all();
  threads.clear();
}

void Scheduler::post(Priority priority, std::function<void()> task) {
  {
    std::lock_guard lock(mutex);
    auto& queue = priority == Priority::Interactive ? interactive : background;
    queue.push_back(std::move(task));
  }
  wake.notify_all();
}

void Scheduler::giveWay() {
  std::unique_lock lock(mutex);
  quiet.wait_for(lock, patience, [this] { return stopping || isQuiet(); });
}

/// \pre the mutex is held
std::optional<Priority> Scheduler::take(bool interactiveOnly, std::function<void()>& task) {
  const bool isInteractive = !interactive.empty();
  auto& queue = isInteractive ? interactive : background;
  if (queue.empty() || (interactiveOnly && !isInteractive)) return std::nullopt;
  task = std::move(queue.front());
  queue.pop_front();
  if (isInteractive) ++interactiveRuns;
  return isInteractive ? Priority::Interactive : Priority::Background;
}

void Scheduler::finished(Priority priority) {
  if (priority != Priority::Interactive) return;
  const std::lock_guard lock(mutex);
  --interactiveRuns;
  if (isQuiet()) quiet.notify_all();
}

void Scheduler::work(bool interactiveOnly) {
  while (true) {
    std::function<void()> task;
    std::optional<Priority> priority;
    {
      std::unique_lock lock(mutex);
      wake.wait(lock, [&] { return stopping || (priority = take(interactiveOnly, task)); });
      if (!priority) return;
    }
    task();
    finished(*priority);
  }
}

} // namespace proskill::rpc
