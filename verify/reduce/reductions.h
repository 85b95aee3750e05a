#pragma once

#include "verify/model/system.h"
#include "verify/state/enabled.h"

#include <cstdint>

namespace proskill::verify {

class StubbornSets;
class LiveVariables;
class FreeInputs;
class PrivateMoves;

/// The reductions that an exploration uses; null or empty: not used.
struct Reductions {
  bool inclusion = false;
  /// Each state has one zone, the hull of those that lead there. What the search finds may not be
  /// reachable, and has no steps. Requires inclusion.
  bool hull = false;
  std::uint8_t mostHulls = 10; ///< of a state; then its hulls are widened
  const StubbornSets* stubbornSets = nullptr;
  const LiveVariables* liveVariables = nullptr;
  const FreeInputs* freeInputs = nullptr;
  const PrivateMoves* privateMoves = nullptr; ///< requires freeInputs
  Bits dropped;                               ///< transitions of processes that only observe
};

} // namespace proskill::verify
