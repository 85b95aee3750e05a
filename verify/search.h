#pragma once

#include "verify/explorer.h"
#include "verify/progress_check.h"

namespace proskill::verify {

/// A way to what a goal asks for, and where the clocks stand at its end where that matters.
struct Evidence {
  Steps steps;
  std::vector<ClockRange> clocks;
};

struct SearchResult {
  std::vector<std::optional<Evidence>> goals; ///< by goal: nothing where nothing was found
  Exploration statistics;
  std::optional<Unsupported> failure;
};

/// Looks for all goals: one exploration, and one more, with finer zones, where the first could not
/// tell whether time can stop.
[[nodiscard]] SearchResult search(const System& system, const std::vector<Goal>& goals,
                                  const Reductions& reductions, Forgetting forgetting,
                                  LimitWatch& limits);

} // namespace proskill::verify
