#pragma once

#include "runtime/machine/executable.h"

#include <memory>
#include <optional>
#include <vector>

namespace proskill::runtime {

/// Clock of a run. Its time is 0 when it starts.
class Clock {
public:
  virtual ~Clock() = default;
  virtual void start() = 0;
  [[nodiscard]] virtual Nanoseconds now() = 0;
  /// Waits until a date, or until one of the descriptors is readable. Returns at once if the date
  /// has passed.
  /// \param date nullopt: no time limit
  virtual void wait(std::optional<Nanoseconds> date, const std::vector<int>& descriptors) = 0;
  /// Whether waiting takes real time.
  [[nodiscard]] virtual bool isReal() const = 0;
};

/// Clock that jumps to the date of each wait.
[[nodiscard]] std::unique_ptr<Clock> simulatedClock();

/// The machine's monotonic clock, which ignores changes of the date and stops while the machine is
/// suspended.
/// \param factor speed relative to real time
[[nodiscard]] std::unique_ptr<Clock> realClock(double factor = 1);

/// A clock whose owner sees its time in ticks: `now` is the last one, and each wait ends at one.
/// \param period of a tick, in the time of the clock
[[nodiscard]] std::unique_ptr<Clock> tickingClock(std::unique_ptr<Clock> inner, Nanoseconds period);

} // namespace proskill::runtime
