#pragma once

#include "runtime/machine/executable.h"

#include <array>
#include <cstdint>
#include <optional>

/// Zones over two dates: now, and when a monitor's clock was reset. They are difference bound
/// matrices as in verify/model/dbm.h, in nanoseconds.
namespace proskill::runtime {

/// An upper bound on a difference of dates: `<= c` is 2c + 1, `< c` is 2c.
using DateBound = std::int64_t;

inline constexpr DateBound kNoBound = INT64_MAX;

[[nodiscard]] constexpr DateBound atMost(Nanoseconds time) { return 2 * time + 1; }
[[nodiscard]] constexpr DateBound plus(DateBound a, DateBound b) {
  return a == kNoBound || b == kNoBound ? kNoBound : a + b - ((a | b) & 1);
}

/// Dates from `first` to `last`, both included. Position 2n is the date n, position 2n + 1 all
/// dates between n and n + 1.
struct DateRange {
  std::int64_t first = 0;
  std::int64_t last = 0;
  friend bool operator==(const DateRange&, const DateRange&) = default;
};

/// Which pairs of dates are possible.
class DateZone {
public:
  DateZone(Nanoseconds now, DateRange reset);

  /// Restricts the clock, which is now - reset. `lower` limits 0 - x, `upper` limits x - 0.
  /// \return false if the zone becomes empty; its content is then undefined
  bool constrainClock(DateBound lower, DateBound upper);
  /// The clock is reset now.
  void reset();
  /// Lets time pass until a date; nullopt: without a limit. \pre it is not before now
  void elapse(std::optional<Nanoseconds> until);
  /// The possible resets if it is `date`; nullopt: it cannot be.
  [[nodiscard]] std::optional<DateRange> resetsAt(Nanoseconds date) const;
  /// The first date that now can be, rounded up to a whole nanosecond.
  [[nodiscard]] Nanoseconds earliest() const;
  [[nodiscard]] bool includes(const DateZone& other) const;

private:
  enum Date : std::uint8_t { kZero, kNow, kReset, kDates };

  bool constrain(Date i, Date j, DateBound limit);
  [[nodiscard]] DateBound at(Date i, Date j) const { return bounds[i * kDates + j]; }
  DateBound& at(Date i, Date j) { return bounds[i * kDates + j]; }

  std::array<DateBound, std::size_t{kDates} * kDates> bounds{};
};

} // namespace proskill::runtime
