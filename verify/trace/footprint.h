#pragma once

#include "verify/state/evaluate.h"

#include <vector>

namespace proskill::verify {

/// What suffices for a node to have the value that it has.
struct Needs {
  std::vector<CellId> before; ///< of the state, or of the one before the step
  std::vector<CellId> after;  ///< of the state after the step
  bool event = false;         ///< that the step happens

  void add(Needs other);
};

/// Finds cells that suffice for a value: with these cells as they are, the node has the value that
/// it has, whatever the others hold. Of a disjunction that is true one operand is enough, and of a
/// conjunction that is false; the one is taken that depends on the fewest steps. An operand is not
/// left out where it might come to a fault.
class Footprints {
public:
  /// \param writers by cell: 0 where no step has changed it \pre the arguments outlive this
  Footprints(const System& of, const std::vector<std::size_t>& writers);

  [[nodiscard]] Needs of(NodeId node, const Moment& moment) const;
  [[nodiscard]] Needs of(NodeId node, const Word* state) const {
    return of(node, Moment{state, nullptr, nullptr});
  }
  /// Of a value that is assigned: nothing where a cell keeps its own.
  [[nodiscard]] Needs ofAssigned(NodeId node, const Word* state, CellId target) const;

private:
  struct Found {
    std::int64_t value = 0;
    Needs needs;
  };

  [[nodiscard]] bool mayFault(NodeId node) const;
  [[nodiscard]] Found walk(NodeId node, const Moment& moment) const;
  [[nodiscard]] Found either(const Node& node, const Moment& moment, bool decisive) const;
  [[nodiscard]] Found strict(NodeId node, const Moment& moment) const;
  [[nodiscard]] std::size_t cost(const Needs& needs) const;
  [[nodiscard]] std::vector<CellId> readBy(NodeId node) const;

  const System& system;
  const std::vector<std::size_t>& writers;
  enum class Fault : std::uint8_t { Unknown, Never, Possible };
  mutable std::vector<Fault> faults; ///< by node, as far as it was asked for
};

} // namespace proskill::verify
