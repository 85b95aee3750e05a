#pragma once

#include "verify/explore/search.h"

namespace proskill::verify {

/// When a step may happen, over all runs through the same steps; and in one run.
struct Window {
  Date earliest;
  std::optional<Date> latest;
  std::int64_t date = 0; ///< in units of 1/scale
};

struct Dating {
  std::int64_t scale = 1;
  std::vector<Window> steps;
  std::int64_t end =
      0; ///< when the evidence is seen, in units of 1/scale: at the last step or later
  std::vector<std::int64_t> marks; ///< when a monitor moves between steps
};

/// Dates for the steps of a run, as a system of difference constraints: each step fires between the
/// bounds of its transition, and before the upper bound of every transition that is enabled then.
/// The run given is the earliest. Nothing where no dates do. Cormen, Leiserson, Rivest, Stein,
/// "Introduction to Algorithms", 24.4.
/// \param enabling of the system, with nothing left out \throw LimitMet
[[nodiscard]] std::optional<Dating> dated(const System& system, const Enabling& enabling,
                                          const Evidence& evidence, LimitWatch& limits);

} // namespace proskill::verify
