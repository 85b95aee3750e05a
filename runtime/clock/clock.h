#pragma once

#include "runtime/machine/executable.h"

#include <memory>
#include <optional>
#include <vector>

namespace proskill::runtime {

/// The time of a run. It begins with 0 when the clock is started.
class Clock {
public:
  virtual ~Clock() = default;
  virtual void start() = 0;
  [[nodiscard]] virtual Nanoseconds now() = 0;
  /// Waits until a date, or until one of the descriptors can be read. A date that has gone by is
  /// not waited for. Nothing: as long as it takes.
  virtual void wait(std::optional<Nanoseconds> date, const std::vector<int>& descriptors) = 0;
  /// Whether a wait takes as long as it says.
  [[nodiscard]] virtual bool isReal() const = 0;
};

/// Jumps to the date that is waited for.
[[nodiscard]] std::unique_ptr<Clock> simulatedClock();

/// The machine's monotonic clock, which does not jump when its date is set and stands still while
/// it is suspended. \param factor how many times as fast as that it is
[[nodiscard]] std::unique_ptr<Clock> realClock(double factor = 1);

} // namespace proskill::runtime
