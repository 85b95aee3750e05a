#pragma once

#include "verify/model/system.h"

#include <optional>
#include <vector>

/// Evaluation of nodes, on packed states and on plain lists of values.
namespace proskill::verify {

/// A step, as goals that watch steps see it.
struct Moment {
  const Word* before = nullptr;
  const Word* after = nullptr;  ///< null: nothing happens
  const Bits* events = nullptr; ///< what happens
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

/// The value of a node over packed cells. `fault` is set to the first that it comes to.
[[nodiscard]] std::int64_t evaluate(const System& system, NodeId node, const Word* state,
                                    FaultId& fault);
/// For guards: a fault counts as false.
[[nodiscard]] inline bool holds(const System& system, NodeId node, const Word* state) {
  FaultId fault = kNoFault;
  return evaluate(system, node, state, fault) != 0 && fault == kNoFault;
}
/// The truth of a goal's condition.
[[nodiscard]] bool holdsAt(const System& system, NodeId node, const Moment& moment);

/// The value of a node where cell i holds values[i]; nothing where it comes to a fault.
[[nodiscard]] std::optional<std::int64_t> evaluateUnpacked(const System& system, NodeId node,
                                                           const std::vector<std::int64_t>& values);

} // namespace proskill::verify
