#pragma once

#include "lsp/server/thread_clock.h"

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace proskill::lsp {

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
