#pragma once

#include "verify/reduce/dead_variables.h"
#include "verify/reduce/free_inputs.h"
#include "verify/reduce/live_variables.h"
#include "verify/reduce/private_moves.h"
#include "verify/reduce/reductions.h"
#include "verify/reduce/stubborn_sets.h"
#include "verify/state/timing.h"
#include "verify/verify.h"

#include <functional>
#include <optional>

namespace proskill::verify {

/// Whether the options have a reduction, and it is sound for the system: with priorities most are
/// not, since a step that is dropped or delayed might have priority over others.
[[nodiscard]] bool mayTake(Reduction reduction, const Options& options, const System& system);

/// A system, reduced for a search for some goals.
struct Prepared {
  /// \param takes whether a reduction may be used \throw LimitMet
  Prepared(const System& whole, const std::vector<Goal>& goals,
           const std::function<bool(Reduction)>& takes, LimitWatch& limits);
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  System system;
  Relevance relevance;
  std::optional<StubbornSets> stubbornSets;
  std::optional<LiveVariables> liveVariables;
  std::optional<FreeInputs> freeInputs;
  std::optional<PrivateMoves> privateMoves;
  Reductions reductions;
  Extrapolation extrapolation;
};

} // namespace proskill::verify
