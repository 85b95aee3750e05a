#pragma once

#include "analysis/flow/engine/solver.h"

#include <optional>
#include <vector>

namespace proskill::analysis::flow {

/// A way round a loop on which no time passes: its waits do not wait, its calls are refused.
struct InstantRound {
  std::vector<NodeId> nodes; ///< in their order
  /// Of the call that is refused first: which precondition of the callee is false.
  struct Refusal {
    NodeId call = kNoNode;
    std::size_t precondition = 0;
  };
  std::optional<Refusal> refusal;
  NodeId wait = kNoNode; ///< the first one that does not wait; none: kNoNode
};

/// A round from one of the nodes back to it that can be repeated for ever: found for values that
/// the solver deems possible, all of which lead round and back to such values. Only rounds with a
/// wait or a call count. Nothing where none is found; that there is one, but for what others do
/// meanwhile, is certain wherever the values are possible.
[[nodiscard]] std::optional<InstantRound> instantRound(const Solver& solver, ProcessId process,
                                                       const std::vector<NodeId>& loop);

/// The node may be part of such a round.
[[nodiscard]] bool mayTakeNoTime(const Solver& solver, ProcessId process, NodeId node);

} // namespace proskill::analysis::flow
