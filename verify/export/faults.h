#pragma once

#include "verify/model/nodes.h"

#include <unordered_map>

namespace proskill::verify {

/// Splits expressions that may fail into two that cannot: for languages in which an evaluation
/// always has a value.
class Faults {
public:
  /// \pre the arguments outlive this
  Faults(Nodes& to, const System& of) : nodes(to), system(of) {}

  /// The value of a node where its evaluation does not fail; elsewhere it must not be evaluated.
  NodeId value(NodeId node);
  /// Whether the evaluation of a node fails.
  NodeId fault(NodeId node);
  /// The value of a condition; false where its evaluation fails.
  NodeId condition(NodeId node) { return both(nodes.negation(fault(node)), value(node)); }

  /// Conjunction and disjunction of conditions that cannot fail, in short.
  NodeId both(NodeId a, NodeId b);
  NodeId either(NodeId a, NodeId b);

private:
  NodeId valueOf(const Node& node);
  NodeId faultOf(const Node& node);
  [[nodiscard]] bool areOpposite(NodeId a, NodeId b) const;

  Nodes& nodes;
  const System& system;
  std::unordered_map<NodeId, NodeId> values;
  std::unordered_map<NodeId, NodeId> faults;
};

} // namespace proskill::verify
