#pragma once

#include "verify/explore/search.h"

namespace proskill::verify {

/// The dates at which a step may happen over all runs with the same steps, and its date in one run.
struct Window {
  Date earliest;
  std::optional<Date> latest;
  std::int64_t date = 0; ///< in units of 1/scale
};

struct Dating {
  std::int64_t scale = 1;
  std::vector<Window> steps;
  std::int64_t end =
      0; ///< When the evidence is complete, in units of 1/scale: at the last step or later.
  std::vector<std::int64_t> marks; ///< dates of the monitor's moves between steps
};

/// Computes dates for the steps of a run as a system of difference constraints: each step fires
/// within its transition's bounds, and before the upper bound of every transition that is enabled
/// then; a monitor leaves a location at once that does not allow the state. The returned run is the
/// earliest. Nothing if there are no such dates. Cormen, Leiserson, Rivest, Stein, "Introduction to
/// Algorithms", 24.4.
///
/// Dates have numbers: 0 is the start, i the i-th step, then come the end and the monitor's moves
/// between steps.
///
/// \param enabling of the system, without skipped transitions
/// \param windows whether the earliest and latest dates are needed, too: this takes three times as
/// long
/// \throw LimitMet
[[nodiscard]] std::optional<Dating> dated(const System& system, const Enabling& enabling,
                                          const Evidence& evidence, LimitWatch& limits,
                                          bool windows = false);

} // namespace proskill::verify
