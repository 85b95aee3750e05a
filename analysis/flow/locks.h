#pragma once

#include "analysis/flow/bits.h"
#include "analysis/flow/system.h"

#include <vector>

namespace proskill::analysis::flow {

/// Skills that exclude each other by a state variable, as in "needs `(motion Free)`, sets `(motion
/// Controlled)` when it starts, and lets go when it ends". For each process the others that cannot
/// be running while it is.
///
/// Why it is sound: let F be the values with which some skill of the group may start and C those
/// that they set; the two have nothing in common, and nobody but a skill of the group that ends
/// sets a value of F. Then at most one of the group runs, and while it does the value is not of F:
/// a start needs a value of F, so that none was running, and leaves one of C.
[[nodiscard]] std::vector<Bits> exclusiveSkills(const System& system);

} // namespace proskill::analysis::flow
