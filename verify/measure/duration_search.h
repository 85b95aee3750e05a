#pragma once

#include "verify/explore/monitor_search.h"
#include "verify/reduce/prepared.h"

#include <memory>

namespace proskill::verify {

/// Whether a reduction may be used for a monitor.
using Suits = std::function<bool(const Monitor&, Reduction)>;

/// A run that shows a duration, and what it was found with.
struct DurationRun {
  Goal goal; ///< of the kind Run; its monitor accepts the run
  std::optional<Prepared> prepared;
  Evidence evidence;
};

struct DurationSearch {
  std::optional<Duration> duration; ///< nothing: see `unknown`
  std::string unknown;              ///< the limit that was met
  std::unique_ptr<DurationRun> run; ///< shows the duration
  Exploration statistics;
  std::optional<Unsupported> failure;
};

/// The goal of a run that shows a time, as an answer to the question; nothing if no run does.
[[nodiscard]] std::optional<Goal> goalShowing(const Goal& goal, const Duration& duration);

/// Measures the longest or the shortest time from P to the next Q over all runs.
///
/// The zone graph of the model and the monitor is explored. Values of the monitor's clock are
/// distinguished up to some constant. If no value exceeds it, the greatest upper bound of the clock
/// in all zones during a measurement is the longest time, and the greatest lower bound at the end
/// of one is found likewise: extrapolation (Extra+LU) adds only values that a reached one
/// simulates, so none with a longer or a shorter time. Otherwise the constant is multiplied, which
/// ends: the shortest time is finite, and the longest one is finite unless some measurement never
/// ends, which is decided first. (If there are longer and longer measurements, one of them passes
/// the same region of the clocks and of a clock of period 1 twice. The part in between can be
/// repeated for ever.)
///
/// \param goal of kind Longest or Shortest
/// \param showsTimes whether a run is found that shows a finite time
/// \throw LimitMet
[[nodiscard]] DurationSearch searchDuration(const System& whole, const Goal& goal,
                                            const Suits& suits, bool errorsAreAsked,
                                            bool showsTimes, LimitWatch& limits);

} // namespace proskill::verify
