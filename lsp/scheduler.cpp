#include "lsp/scheduler.h"

#include <cassert>

namespace proskill::lsp {

Scheduler::Scheduler(unsigned count) {
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

/// \pre the mutex is held
bool Scheduler::take(bool interactiveOnly, std::function<void()>& task) {
  auto* queue = !interactive.empty() ? &interactive : &background;
  if (queue->empty() || (interactiveOnly && queue == &background)) return false;
  task = std::move(queue->front());
  queue->pop_front();
  return true;
}

void Scheduler::work(bool interactiveOnly) {
  while (true) {
    std::function<void()> task;
    {
      std::unique_lock lock(mutex);
      wake.wait(lock, [&] { return stopping || take(interactiveOnly, task); });
      if (!task) return;
    }
    task();
  }
}

} // namespace proskill::lsp
