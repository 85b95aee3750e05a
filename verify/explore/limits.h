#pragma once

#include "verify/verify.h"

#include <chrono>

namespace proskill::verify {

/// Watches over the limits of an exploration and reports how it goes on.
class LimitWatch {
public:
  explicit LimitWatch(const Options& of) : options(of) {}

  /// Which limit is met, empty where none is. Calls the progress function a few times a second.
  [[nodiscard]] std::string met(const Progress& now);
  [[nodiscard]] double seconds() const;

private:
  using Clock = std::chrono::steady_clock;

  const Options& options;
  Clock::time_point start = Clock::now();
  Clock::time_point reported = start;
};

} // namespace proskill::verify
