#include "verify/threads/team.h"

#include <system_error>
#include <utility>

namespace proskill::verify {

namespace {

/// Waits while `value` is `old`. Tasks are often short, so at first the thread stays awake.
template <class Number> void awaitChange(const std::atomic<Number>& value, Number old) {
  constexpr int kSpins = 1000; // some 20 µs
  for (int i = 0; i < kSpins; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }
  value.wait(old);
}

} // namespace

Team::Team(std::size_t members) {
  try {
    for (std::size_t i = 1; i < members; ++i)
      threads.emplace_back([this, i](const std::stop_token& stop) { serve(i, stop); });
  } catch (const std::system_error&) {
    // the system has no thread left: the others do its part
  }
}

Team::~Team() {
  for (auto& thread : threads) thread.request_stop();
  ++round;
  round.notify_all();
}

void Team::inAll(Task task) {
  current = std::move(task);
  busy = threads.size();
  ++round;
  round.notify_all();
  attempt(0);
  for (auto left = busy.load(); left != 0; left = busy.load()) awaitChange(busy, left);
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
  for (std::uint64_t seen = 0;; ++seen) {
    awaitChange(round, seen);
    if (stop.stop_requested()) return;
    attempt(member);
    if (--busy == 0) busy.notify_all();
  }
}

} // namespace proskill::verify
