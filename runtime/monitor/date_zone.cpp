#include "runtime/monitor/date_zone.h"

#include <algorithm>

namespace proskill::runtime {

DateZone::DateZone(Nanoseconds now, DateRange reset) {
  for (const auto i : {kZero, kNow, kReset}) at(i, i) = atMost(0);
  at(kNow, kZero) = atMost(now);
  at(kZero, kNow) = atMost(-now);
  at(kReset, kZero) = reset.last + 1;
  at(kZero, kReset) = 1 - reset.first;
  at(kNow, kReset) = plus(at(kNow, kZero), at(kZero, kReset));
  at(kReset, kNow) = plus(at(kReset, kZero), at(kZero, kNow));
}

bool DateZone::constrain(Date i, Date j, DateBound limit) {
  if (limit >= at(i, j)) return true;
  const auto around = plus(limit, at(j, i));
  if (around < atMost(0)) return false;
  at(i, j) = limit;
  for (const auto from : {kZero, kNow, kReset})
    for (const auto to : {kZero, kNow, kReset})
      at(from, to) = std::min(at(from, to), plus(plus(at(from, i), limit), at(j, to)));
  return true;
}

bool DateZone::constrainClock(DateBound lower, DateBound upper) {
  return constrain(kReset, kNow, lower) && constrain(kNow, kReset, upper);
}

void DateZone::reset() {
  at(kReset, kZero) = at(kNow, kZero);
  at(kZero, kReset) = at(kZero, kNow);
  at(kNow, kReset) = at(kReset, kNow) = atMost(0);
}

void DateZone::elapse(std::optional<Nanoseconds> until) {
  at(kNow, kZero) = at(kNow, kReset) = kNoBound;
  if (until) constrain(kNow, kZero, atMost(*until));
}

std::optional<DateRange> DateZone::resetsAt(Nanoseconds date) const {
  DateZone then = *this;
  if (!then.constrain(kNow, kZero, atMost(date)) || !then.constrain(kZero, kNow, atMost(-date)))
    return std::nullopt;
  return DateRange{1 - then.at(kZero, kReset), then.at(kReset, kZero) - 1};
}

Nanoseconds DateZone::earliest() const {
  const auto first = 1 - at(kZero, kNow);
  return (first + (first & 1)) / 2;
}

bool DateZone::includes(const DateZone& other) const {
  return std::ranges::equal(bounds, other.bounds, std::greater_equal{});
}

} // namespace proskill::runtime
