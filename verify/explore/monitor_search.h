#pragma once

#include "verify/explore/search.h"
#include "verify/limits.h"
#include "verify/model/monitor.h"
#include "verify/reduce/reductions.h"

namespace proskill::verify {

/// What the search for a run that a monitor accepts came to.
struct Watched {
  std::optional<Evidence> evidence;
  Exploration statistics;
  std::string failure; ///< an error of the model that nobody asked for
  fiacre::OriginId failureOrigin = 0;
};

/// Looks for a run that the monitor accepts, in the zone graph of the model with the monitor's
/// clock. An error location is looked for as any state is; for the others the graph is searched for
/// a cycle through an accepting location, with no zone left out for another that includes it:
/// Extra+LU keeps the answer, see Li, "Formal verification of timed automata by means of
/// LU-abstractions" (FORMATS 2009); Tarjan, "Depth-first search and linear graph algorithms", SIAM
/// J. Comput. 1972. Runs are maximal sequences of steps; they need not let time diverge.
/// Where only fair runs count, the cycle has a tick (see MonitorZones), and each open wait of an
/// obliged process either ends on it or is left for a while.
/// \pre stubborn sets and free inputs are taken only where watchesPoints()
[[nodiscard]] Watched watchFor(const System& system, const Monitor& monitor,
                               const Reductions& reductions, const std::set<std::string>& obliged,
                               bool errorsAreAsked, LimitWatch& limits);

} // namespace proskill::verify
