#pragma once

#include "verify/explore/search.h"
#include "verify/reduce/prepared.h"

namespace proskill::verify {

/// The result of searching for a moment from which a condition cannot be seen any more.
struct LostSearch {
  std::optional<Evidence> evidence;
  Exploration statistics;
  std::string failure; ///< an error of the model that no goal asks for
  fiacre::OriginId failureOrigin = 0;
};

/// What reductions have to preserve for a goal of kind Lost.
[[nodiscard]] std::vector<Goal> preservedFor(const Goal& goal);

/// Explores the whole system and searches for a lost moment: see LostStates.
/// \param prepared with the reductions that preserve preservedFor(goal)
[[nodiscard]] LostSearch searchLost(const Prepared& prepared, const Goal& goal, bool errorsAreAsked,
                                    LimitWatch& limits);

} // namespace proskill::verify
