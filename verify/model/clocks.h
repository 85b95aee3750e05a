#pragma once

#include "verify/model/system.h"

namespace proskill::verify {

/// Whether the interval is [0,0]: the transition is urgent.
[[nodiscard]] inline bool isImmediate(const fiacre::Interval& interval) {
  return interval.upper == 0 && !interval.lowerOpen && !interval.upperOpen;
}

/// Whether the transition needs a clock: its interval is neither [0,0] nor [0,...[.
[[nodiscard]] inline bool isClocked(const fiacre::Interval& interval) {
  bool always = interval.lower == 0 && !interval.lowerOpen && !interval.upper;
  return !isImmediate(interval) && !always;
}

/// Assigns clocks to the transitions that need one. Transitions of one location of an instance
/// share the instance's clock if none of them can become enabled or disabled while the instance
/// stays in the location. Other transitions have a clock of their own; a synchronisation with
/// observers shares it with the same synchronisation without them.
void assignClocks(System& system);

} // namespace proskill::verify
