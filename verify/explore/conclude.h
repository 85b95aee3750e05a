#pragma once

#include "verify/limits.h"

namespace proskill::verify {

/// Explores until a limit is met, if one is, and notes which.
template <typename Explore> void exploreWithinLimits(Exploration& statistics, Explore explore) {
  try {
    explore();
  } catch (const LimitMet& limit) {
    statistics.stopped = limit.which;
  }
}

/// Says whether an exploration is complete, or why it ended before.
/// \param failure an error of the model, empty where there is none
/// \param otherwise why it ended where neither a limit nor an error ended it
inline void conclude(Exploration& statistics, bool isAtEnd, const std::string& failure,
                     const std::string& otherwise) {
  statistics.complete = isAtEnd && failure.empty() && statistics.stopped.empty();
  if (!statistics.complete && statistics.stopped.empty())
    statistics.stopped = failure.empty() ? otherwise : "an error of the model";
}

} // namespace proskill::verify
