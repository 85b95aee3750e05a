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
/// then. The returned run is the earliest. Nothing if there are no such dates. Cormen, Leiserson,
/// Rivest, Stein, "Introduction to Algorithms", 24.4.
/// \param enabling of the system, without skipped transitions
/// \throw LimitMet
[[nodiscard]] std::optional<Dating> dated(const System& system, const Enabling& enabling,
                                          const Evidence& evidence, LimitWatch& limits);

} // namespace proskill::verify
