#pragma once

#include "verify/model/system.h"
#include "verify/state/enabled.h"

namespace proskill::verify {

class StubbornSets;
class LiveVariables;
class FreeInputs;
class PrivateMoves;

/// The reductions that an exploration uses; null or empty: not used.
struct Reductions {
  bool inclusion = false;
  const StubbornSets* stubbornSets = nullptr;
  const LiveVariables* liveVariables = nullptr;
  const FreeInputs* freeInputs = nullptr;
  const PrivateMoves* privateMoves = nullptr; ///< requires freeInputs
  Bits dropped;                               ///< transitions of processes that only observe
};

} // namespace proskill::verify
