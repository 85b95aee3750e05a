#pragma once

#include "verify/limits.h"

namespace proskill::verify {

/// Explores until the end or until a limit is met, and records the limit.
template <typename Explore> void exploreWithinLimits(Exploration& statistics, Explore explore) {
  try {
    explore();
  } catch (const LimitMet& limit) {
    statistics.stopped = limit.which;
  }
}

/// Records whether an exploration is complete, or why it stopped.
/// \param failure an error of the model; empty if there is none
/// \param otherwise the reason if neither a limit nor an error stopped it
inline void conclude(Exploration& statistics, bool isAtEnd, const std::string& failure,
                     const std::string& otherwise) {
  statistics.complete = isAtEnd && failure.empty() && statistics.stopped.empty();
  if (!statistics.complete && statistics.stopped.empty())
    statistics.stopped = failure.empty() ? otherwise : "an error of the model";
}

} // namespace proskill::verify
