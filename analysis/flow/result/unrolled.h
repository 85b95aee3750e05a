#pragma once

#include "analysis/flow/engine/solver.h"

#include <vector>

namespace proskill::analysis::flow {

/// The graph of a process with counting loops unrolled: it has a copy of a node for each value of
/// the naturals with which the process counts. Every path of the process is a path in it.
struct Unrolled {
  Graph graph;                  ///< reachable nodes and their edges
  std::vector<NodeId> original; ///< by node: the node of the process
};

/// Unrolls over the naturals that the process tests and sets and that nobody else sets meanwhile.
/// If there are none, or too many values, each node has one copy. \pre the process is started
[[nodiscard]] Unrolled unrolled(const Solver& solver, ProcessId process);

} // namespace proskill::analysis::flow
