#include "verify/explore/team.h"

#include <utility>

namespace proskill::verify {

Team::Team(std::size_t members) {
  for (std::size_t i = 1; i < members; ++i)
    threads.emplace_back([this, i](const std::stop_token& stop) { serve(i, stop); });
}

Team::~Team() {
  for (auto& thread : threads) thread.request_stop();
  {
    const std::lock_guard lock(guard);
    ++round;
  }
  changed.notify_all();
}

void Team::inAll(Task task) {
  {
    const std::lock_guard lock(guard);
    current = std::move(task);
    ++round;
    busy = threads.size();
  }
  changed.notify_all();
  attempt(0);
  std::unique_lock lock(guard);
  changed.wait(lock, [this] { return busy == 0; });
  if (failure) std::rethrow_exception(std::exchange(failure, nullptr));
}

void Team::attempt(std::size_t member) {
  try {
    current(member);
  } catch (...) {
    const std::lock_guard lock(guard);
    failure = std::current_exception();
  }
}

void Team::serve(std::size_t member, const std::stop_token& stop) {
  std::unique_lock lock(guard);
  for (std::uint64_t seen = 0;;) {
    changed.wait(lock, [&] { return round != seen; });
    seen = round;
    if (stop.stop_requested()) return;
    lock.unlock();
    attempt(member);
    lock.lock();
    if (--busy == 0) changed.notify_all();
  }
}

} // namespace proskill::verify
