#pragma once

#include "verify/model/system.h"
#include "verify/state/enabled.h"

namespace proskill::verify {

class SafeSteps;
class LiveVariables;
class OpenVariables;

/// The measures that an exploration takes; what is null or empty is not taken.
struct Reductions {
  bool inclusion = false;
  const SafeSteps* safeSteps = nullptr;
  const LiveVariables* liveVariables = nullptr;
  const OpenVariables* openVariables = nullptr;
  Bits dropped; ///< transitions of processes that only watch
};

} // namespace proskill::verify
