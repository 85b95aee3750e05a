#pragma once

#include "verify/explore/monitor_zones.h"
#include "verify/explore/search.h"
#include "verify/limits.h"
#include "verify/model/monitor.h"
#include "verify/reduce/reductions.h"

namespace proskill::verify {

/// The result of searching for a run that a monitor accepts.
struct Watched {
  std::optional<Evidence> evidence;
  Exploration statistics;
  std::string failure; ///< an error of the model that no goal asks for
  fiacre::OriginId failureOrigin = 0;
  bool paused = false; ///< it has as many classes as it may have
};

/// Searches the zone graph of the model and the monitor's clock for a run that the monitor accepts.
/// Error locations are found as any state is. For accepting locations the graph is searched for a
/// cycle through one of them, without inclusion of zones. Extra+LU preserves the result: Li,
/// "Formal verification of timed automata by means of LU-abstractions" (FORMATS 2009). Cycles:
/// Tarjan, "Depth-first search and linear graph algorithms", SIAM J. Comput. 1972. Runs are maximal
/// sequences of steps; time need not diverge in them. If only fair runs count, the cycle contains a
/// tick (see MonitorZones), and each open wait of an obliged process either ends on it or is
/// interrupted.
/// \param measured receives the values of the clock of a monitor of durations; then everything is
/// explored
/// \param most number of classes, after which the search ends without a result
/// \pre stubborn sets and free inputs are used only if watchesPoints()
[[nodiscard]] Watched watchFor(const System& system, const Monitor& monitor,
                               const Reductions& reductions, const std::set<std::string>& obliged,
                               bool errorsAreAsked, LimitWatch& limits,
                               MeasuredClock* measured = nullptr, std::uint64_t most = UINT64_MAX);

} // namespace proskill::verify
