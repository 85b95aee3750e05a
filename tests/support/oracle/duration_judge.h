#pragma once

#include "tests/support/oracle/judge.h"

#include "verify/verify.h"

namespace proskill::oracle {

/// The longest or the shortest time from the first operand of a pattern to the next second one,
/// read from the ages in a region graph. `bounded` is false if it is beyond the watch of the graph.
/// \pre the graph has a watch and is complete
[[nodiscard]] verify::Duration durationOf(const Interpreter& model, const RegionGraph& graph,
                                          const fiacre::Pattern& pattern);

} // namespace proskill::oracle
