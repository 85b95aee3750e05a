#pragma once

#include "verify/model/system.h"

namespace proskill::verify {

/// [0,0]: has to happen at once.
[[nodiscard]] inline bool isImmediate(const fiacre::Interval& interval) {
  return interval.upper == 0 && !interval.lowerOpen && !interval.upperOpen;
}

/// Neither [0,0] nor [0,...[: how long the transition has been enabled matters.
[[nodiscard]] inline bool isClocked(const fiacre::Interval& interval) {
  bool always = interval.lower == 0 && !interval.lowerOpen && !interval.upper;
  return !isImmediate(interval) && !always;
}

/// Gives clocks to the transitions that need one. Those of one location of one instance share the
/// instance's clock where none of them can become enabled or disabled while the instance stays
/// there; others have their own, which a step with observers shares with the same one without.
void assignClocks(System& system);

} // namespace proskill::verify
