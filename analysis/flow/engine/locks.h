#pragma once

#include "analysis/flow/domain/id_set.h"
#include "analysis/flow/engine/system.h"

#include <vector>

namespace proskill::analysis::flow {

/// Skills that exclude each other by a state variable that is used as a lock: taken by whoever
/// finds it free, in the same step, as in "needs `(motion Free)`, starts by `(motion Controlled)`"
/// or
/// `(^ (zone Free) :effects (zone Taken))`, and freed by its holder alone. For each skill the
/// others that cannot be running while it is at a step of its own.
///
/// Why it is sound: let F be the values with which somebody takes the lock and C those that are set
/// then; the two have nothing in common, and nobody but a holder sets a value of F. Then at most
/// one thread holds the lock, and while it does the value is not of F: to take it needs a value of
/// F, so that nobody held it, and leaves one of C. A skill holds it while it runs where it takes it
/// as it starts, or where every call of it is made by somebody who holds it; a thread that holds it
/// makes one call at a time.
[[nodiscard]] std::vector<IdSet> exclusiveSkills(const System& system);

} // namespace proskill::analysis::flow
