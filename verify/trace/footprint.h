#pragma once

#include "verify/state/evaluate.h"

#include <vector>

namespace proskill::verify {

/// What suffices for a node to have its value.
struct Needs {
  std::vector<CellId> before; ///< of the state, or of the state before the step
  std::vector<CellId> after;  ///< of the state after the step
  bool event = false;         ///< the value depends on what happens in the step

  void add(Needs other);
};

/// Computes sufficient cells for a value: while these cells keep their values, the node keeps its
/// value, whatever the other cells hold. For a true disjunction or a false conjunction, one operand
/// suffices; the operand that depends on the fewest steps is chosen. An operand that might cause a
/// fault is always included.
class Footprints {
public:
  /// \param writers by cell: number of the step that changed it last; 0 if none did
  /// \pre the arguments outlive this
  Footprints(const System& of, const std::vector<std::size_t>& writers);

  [[nodiscard]] Needs of(NodeId node, const Moment& moment) const;
  [[nodiscard]] Needs of(NodeId node, const Word* state) const {
    return of(node, Moment{state, nullptr, nullptr});
  }
  /// The needs of a value that is assigned; none if the cell keeps its value.
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

  const System& system;
  const std::vector<std::size_t>& writers;
  enum class Fault : std::uint8_t { Unknown, Never, Possible };
  mutable std::vector<Fault> faults; ///< by node, computed on demand
};

} // namespace proskill::verify
