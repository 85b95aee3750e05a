#pragma once

#include "verify/model/system.h"

#include <optional>
#include <vector>

/// Evaluation of nodes, on packed states and on lists of values.
namespace proskill::verify {

/// A state or a step, as goals read it.
struct Moment {
  const Word* before = nullptr;
  const Word* after = nullptr;  ///< the state after the step; null: no step is taken
  const Bits* events = nullptr; ///< the events of the step
};

[[nodiscard]] inline std::int64_t readCell(const System& system, CellId id, const Word* state) {
  const Cell& cell = system.cells[id];
  return static_cast<std::int64_t>((state[cell.word] & cell.mask) >> cell.shift) + cell.low;
}

inline void writeCell(const System& system, CellId id, std::int64_t value, Word* state) {
  const Cell& cell = system.cells[id];
  state[cell.word] =
      (state[cell.word] & ~cell.mask) | (static_cast<Word>(value - cell.low) << cell.shift);
}

/// The value of a node in a packed state. On a fault, `fault` is set to the first one.
[[nodiscard]] std::int64_t evaluate(const System& system, NodeId node, const Word* state,
                                    FaultId& fault);
/// The value of a guard. A fault counts as false.
[[nodiscard]] inline bool holds(const System& system, NodeId id, const Word* state) {
  const Node& node = system.nodes[id];
  if (node.op == NodeOp::Test) return (state[node.a] & node.mask) == node.value; // most of them
  FaultId fault = kNoFault;
  return evaluate(system, id, state, fault) != 0 && fault == kNoFault;
}
/// The value of a goal's condition.
[[nodiscard]] bool holdsAt(const System& system, NodeId node, const Moment& moment);

/// The value of a node if cell i has values[i]; nothing on a fault.
[[nodiscard]] std::optional<std::int64_t> evaluateUnpacked(const System& system, NodeId node,
                                                           const std::vector<std::int64_t>& values);

} // namespace proskill::verify
