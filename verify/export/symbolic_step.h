#pragma once

#include "verify/export/faults.h"

#include <map>
#include <optional>

namespace proskill::verify {

/// A step as expressions over the state before it, none of which can fail.
struct SymbolicStep {
  NodeId gaveUp = 0;                 ///< an `on` on its way is false, so the step is not possible
  NodeId finished = 0;               ///< it comes to its end, without a fault
  std::map<CellId, NodeId> after;    ///< by cell that it may write: the value where it finishes
  std::map<EventId, NodeId> happens; ///< by event: whether it happens, where the step finishes
};

/// Executes the code of a transition on expressions instead of values.
/// \pre the guard holds \throw CompileError if the code has a loop
[[nodiscard]] SymbolicStep symbolicStep(const System& system, const Transition& transition,
                                        Nodes& nodes, Faults& faults);

/// Whether the discrete state enables the transition, without regard to priorities. Cannot fail.
/// \throw CompileError if an `on` of the transition follows a loop
[[nodiscard]] NodeId enabledNode(const System& system, const Transition& transition, Nodes& nodes,
                                 Faults& faults);

} // namespace proskill::verify
