#pragma once

#include "analysis/flow/engine/solver.h"
#include "analysis/flow/result/disturbances.h"

#include <optional>
#include <vector>

namespace proskill::analysis::flow {

/// A cycle of a loop that takes no time: its waits do not wait, its calls are refused, or call
/// bodies that take no time either.
struct InstantRound {
  std::vector<NodeId> nodes; ///< in their order
  /// For the first refused call, in the loop or in a body that it calls: the false precondition.
  struct Refusal {
    ProcessId caller = kNoProcess;
    NodeId call = kNoNode;
    std::size_t precondition = 0;
  };
  std::optional<Refusal> refusal;
  NodeId wait = kNoNode; ///< the first wait that does not wait; kNoNode: none
};

/// Searches for a cycle through one of the nodes that takes no time and can repeat for ever. It is
/// found for values that the solver considers possible and that all lead through the cycle back to
/// such values. Only cycles with a wait or a call count. Nothing if none is found. If the values
/// are possible, the cycle exists, unless other processes interfere.
[[nodiscard]] std::optional<InstantRound> instantRound(const Solver& solver,
                                                       const Disturbances& others,
                                                       ProcessId process,
                                                       const std::vector<NodeId>& loop);

/// Whether the node may be part of such a cycle.
[[nodiscard]] bool mayTakeNoTime(const Solver& solver, const Disturbances& others,
                                 ProcessId process, NodeId node);

} // namespace proskill::analysis::flow
