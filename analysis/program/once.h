#pragma once

#include <atomic>
#include <cstdint>
#include <utility>

namespace proskill::analysis {

/// Computes something once: the first caller computes, others wait. If the computation throws, for
/// example because it is cancelled, the next caller starts it again. `std::call_once` promises the
/// same, but after an exception it hangs under the thread sanitizer.
class Once {
public:
  template <class Compute> void operator()(Compute&& compute) {
    if (!begin()) return;
    try {
      std::forward<Compute>(compute)();
    } catch (...) {
      end(kOpen);
      throw;
    }
    end(kDone);
  }

private:
  static constexpr std::uint32_t kOpen = 0;
  static constexpr std::uint32_t kComputing = 1;
  static constexpr std::uint32_t kDone = 2;

  /// Whether the caller must compute; otherwise returns when the result is available.
  bool begin() {
    for (auto seen = state.load(std::memory_order_acquire); seen != kDone;
         seen = state.load(std::memory_order_acquire)) {
      if (seen == kComputing)
        state.wait(kComputing, std::memory_order_acquire);
      else if (state.compare_exchange_strong(seen, kComputing, std::memory_order_acquire))
        return true;
    }
    return false;
  }

  void end(std::uint32_t now) {
    state.store(now, std::memory_order_release);
    state.notify_all();
  }

  std::atomic<std::uint32_t> state = kOpen;
};

} // namespace proskill::analysis
