#pragma once

#include "verify/model/monitor.h"
#include "verify/model/nodes.h"

#include "fiacre/syntax/tree.h"

#include <functional>

namespace proskill::verify {

/// The monitor that accepts the runs of which the formula is false. A position is a state with the
/// step that leaves it; the last state of a run that ends is repeated for ever, as in selt.
/// Gerth, Peled, Vardi, Wolper, "Simple on-the-fly automatic verification of linear temporal
/// logic", PSTV 1995. \param atom the condition of an observable
[[nodiscard]] Monitor negated(const fiacre::Ltl& formula, Nodes& nodes,
                              const std::function<NodeId(const fiacre::Observable&)>& atom);

} // namespace proskill::verify
