#pragma once

#include "verify/model/system.h"
#include "verify/state/enabled.h"

namespace proskill::verify {

class StubbornSets;
class LiveVariables;
class FreeInputs;
class PrivateMoves;

/// The measures that an exploration takes; what is null or empty is not taken.
struct Reductions {
  bool inclusion = false;
  const StubbornSets* stubbornSets = nullptr;
  const LiveVariables* liveVariables = nullptr;
  const FreeInputs* freeInputs = nullptr;
  const PrivateMoves* privateMoves = nullptr; ///< only with free inputs
  Bits dropped;                               ///< transitions of processes that only watch
};

} // namespace proskill::verify
