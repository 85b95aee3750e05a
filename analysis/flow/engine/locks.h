#pragma once

#include "analysis/flow/domain/id_set.h"
#include "analysis/flow/engine/system.h"

#include <vector>

namespace proskill::analysis::flow {

/// Skills that exclude each other by a state variable used as a lock. Whoever finds the lock free
/// takes it in the same step, as in "needs `(motion Free)`, starts by `(motion Controlled)`" or `(^
/// (zone Free) :effects (zone Taken))`, and only its holder frees it. Returns, for each skill, the
/// other skills that cannot run while it is at a step of its own.
///
/// Why it is sound: let F be the values with which some process takes the lock, and C the values
/// that are set then. F and C are disjoint, and only a holder sets a value of F. Then at most one
/// thread holds the lock, and while it does, the value is not in F: taking the lock needs a value
/// of F, so nobody held it before, and sets a value of C. A skill holds the lock while it runs if
/// it takes it as it starts, or if each of its calls is made by a holder; a holder makes one call
/// at a time.
[[nodiscard]] std::vector<IdSet> exclusiveSkills(const System& system);

} // namespace proskill::analysis::flow
