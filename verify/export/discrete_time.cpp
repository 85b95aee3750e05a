#include "verify/export/discrete_time.h"

#include <algorithm>
#include <numeric>

namespace proskill::verify {

DiscreteTime::DiscreteTime(const System& system) : greatest(system.clocks.size()) {
  for (const auto& transition : system.transitions) {
    if (!transition.laterBlockers.empty()) factor = 2; // it fires only strictly before they may
    if (transition.clock == kNone) continue;
    const auto& interval = transition.interval;
    divisor = std::gcd(divisor, std::gcd(interval.lower, interval.upper.value_or(0)));
    if (interval.lowerOpen || (interval.upper && interval.upperOpen)) factor = 2;
  }
  divisor = std::max<std::int64_t>(divisor, 1);
  for (const auto& transition : system.transitions) {
    if (transition.clock == kNone) continue;
    auto& most = greatest[transition.clock];
    most = std::max(most, lower(transition.interval));
    if (transition.interval.upper) most = std::max(most, upper(transition.interval) + 1);
  }
}

std::int64_t DiscreteTime::lower(const fiacre::Interval& interval) const {
  return factor * interval.lower / divisor + (interval.lowerOpen ? 1 : 0);
}

std::int64_t DiscreteTime::upper(const fiacre::Interval& interval) const {
  return factor * *interval.upper / divisor - (interval.upperOpen ? 1 : 0);
}

} // namespace proskill::verify
