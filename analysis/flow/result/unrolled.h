#pragma once

#include "analysis/flow/engine/solver.h"

#include <vector>

namespace proskill::analysis::flow {

/// The graph of a process in which loops that count are laid out round by round: a node stands
/// there once for each value of the naturals that the process counts with. Every way that the
/// process can go is a way through it.
struct Unrolled {
  Graph graph;                  ///< of the nodes that can be reached, and their edges
  std::vector<NodeId> original; ///< of each node, that of the process
};

/// The naturals are those that the process tests and sets, and nobody else sets meanwhile. Where
/// there are none, or their values are too many, each node stands there once. \pre it is started
[[nodiscard]] Unrolled unrolled(const Solver& solver, ProcessId process);

} // namespace proskill::analysis::flow
