#pragma once

#include "verify/export/identifiers.h"
#include "verify/model/nodes.h"

#include <functional>

namespace proskill::verify {

/// How the parts of a system are called in Promela, and its expressions.
class PromelaNames {
public:
  /// \pre the argument outlives this
  explicit PromelaNames(const System& system);

  [[nodiscard]] const std::string& cell(CellId cell) const { return cells[cell]; }
  [[nodiscard]] std::string clock(ClockId clock) const { return "x" + std::to_string(clock); }
  /// A macro: whether the discrete state enables the transition.
  [[nodiscard]] std::string enabled(TransitionId id) const { return "can_" + std::to_string(id); }
  /// Whether the event happened in the current step.
  [[nodiscard]] std::string event(EventId event) const { return "e" + std::to_string(event); }
  /// The value of the cell before the current step.
  [[nodiscard]] std::string before(CellId cell) const { return "before_" + cells[cell]; }
  [[nodiscard]] std::string property(const std::string& name) { return taken.make("p_", name); }

  /// An expression over a state, which cannot fail.
  /// \throw CompileError if a number in it does not fit an `int`
  [[nodiscard]] std::string text(NodeId node) const;
  /// The same; the given cells have the values before the step.
  [[nodiscard]] std::string text(NodeId node, const Bits& before) const;
  /// A condition over a step and the states around it, after the step.
  [[nodiscard]] std::string overStep(NodeId node) const;

private:
  /// How the leaves of an expression are called.
  struct Leaves {
    std::function<std::string(CellId)> cell;
    bool ofStep = false; ///< otherwise nothing happens
  };
  std::string write(NodeId node, const Leaves& leaves) const;
  std::string change(const Node& node) const;

  const System& system;
  Identifiers taken;
  std::vector<std::string> cells;
};

/// The smallest type of Promela for numbers within these bounds.
/// \throw CompileError if there is none
[[nodiscard]] std::string promelaType(std::int64_t low, std::int64_t high);

} // namespace proskill::verify
