#pragma once

#include "verify/model/monitor.h"
#include "verify/model/nodes.h"

#include "fiacre/syntax/tree.h"

#include <functional>

namespace proskill::verify {

/// The monitor that accepts the runs that violate the formula. A position is a state together with
/// the step that leaves it. The last state of a finite run repeats for ever, as in selt. Gerth,
/// Peled, Vardi, Wolper, "Simple on-the-fly automatic verification of linear temporal logic", PSTV
/// 1995.
/// \param atom returns the condition of an observable
[[nodiscard]] Monitor negated(const fiacre::Ltl& formula, Nodes& nodes,
                              const std::function<NodeId(const fiacre::Observable&)>& atom);

} // namespace proskill::verify
