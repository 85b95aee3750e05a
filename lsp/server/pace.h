#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>

namespace proskill::lsp {

/// Processor time of the calling thread. Unlike the time that passes, it does not grow while a busy
/// machine runs others.
struct ThreadClock {
  using duration = std::chrono::nanoseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<ThreadClock>;
  static constexpr bool is_steady = true;

  [[nodiscard]] static time_point now() noexcept {
    timespec used{};
    (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return time_point(std::chrono::seconds(used.tv_sec) + std::chrono::nanoseconds(used.tv_nsec));
  }
};

/// The cost of the last round of diagnostics. If it was very low, the next round need not wait for
/// a pause in typing. A round that an edit cancelled does not count as quick. Costs are processor
/// times, since on a busy machine a wait would only add to the delay.
class Pace {
public:
  using Duration = ThreadClock::duration;

  /// A delay that a user does not notice.
  static constexpr std::chrono::milliseconds kUnnoticed{5};

  /// A round begins: `count` texts of this revision.
  void begin(std::uint64_t revision, std::size_t count) {
    current = revision;
    unfinished = count;
    slowest = {};
    known = true;
  }

  /// A text of a revision's round is done; texts of earlier rounds are ignored.
  void finish(std::uint64_t revision, Duration took) {
    if (!known || revision != current || unfinished == 0) return;
    --unfinished;
    slowest = std::max(slowest, took);
  }

  [[nodiscard]] bool isQuick() const { return known && unfinished == 0 && slowest < kUnnoticed; }

private:
  bool known = false;
  std::uint64_t current = 0;
  std::size_t unfinished = 0;
  Duration slowest{};
};

} // namespace proskill::lsp
