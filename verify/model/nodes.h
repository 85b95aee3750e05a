#pragma once

#include "verify/model/number_table.h"
#include "verify/model/system.h"

#include <functional>
#include <optional>
#include <set>

namespace proskill::verify {

/// Builds expressions. Equal expressions share one node; constants are folded.
class Nodes {
public:
  /// \param check called now and then while the system's nodes are read; it may throw
  explicit Nodes(System& of, const std::function<void()>& check = {});

  NodeId number(std::int64_t value);
  NodeId cell(CellId cell);
  NodeId unary(NodeOp op, NodeId a);
  NodeId binary(NodeOp op, NodeId a, NodeId b);
  NodeId conditional(NodeId a, NodeId b, NodeId c);
  NodeId negation(NodeId a) { return unary(NodeOp::Not, a); }
  NodeId both(NodeId a, NodeId b) { return binary(NodeOp::And, a, b); }
  NodeId equal(NodeId a, NodeId b) { return binary(NodeOp::Equal, a, b); }
  NodeId happens(EventId event);
  NodeId received(std::uint32_t part) { return make({.op = NodeOp::Received, .a = part}); }
  /// `value` if `condition` holds, otherwise the fault.
  NodeId require(NodeId condition, NodeId value, FaultId fault);
  /// `value` if it is between `low` and `high`, both included; otherwise the fault.
  NodeId between(NodeId value, std::int64_t low, std::int64_t high, FaultId fault);
  /// Whether evaluating the node causes a fault.
  NodeId fails(NodeId node) { return unary(NodeOp::Fails, node); }
  /// The fault with this description.
  FaultId fault(const std::string& words);
  /// A copy of the node with leaves replaced: for each Cell, Happens or Received, `leaf` returns
  /// the replacement, or nothing to keep it.
  using Leaf = std::function<std::optional<NodeId>(const Node&)>;
  NodeId substitute(NodeId node, const Leaf& leaf);

  [[nodiscard]] std::optional<std::int64_t> constant(NodeId node) const;

private:
  NodeId make(Node node);
  [[nodiscard]] std::optional<NodeId> folded(NodeOp op, NodeId a, NodeId b);

  System& system;
  NumberTable known;
};

/// Adds the cells that a node reads.
void addReads(const System& system, NodeId node, Bits& cells);
/// The cells that a node reads, ascending.
[[nodiscard]] std::vector<CellId> readsOf(const System& system, NodeId node);
/// Adds the events that a node watches.
void addEvents(const System& system, NodeId node, Bits& events);
/// The parts of a node that depend on what happens in a step: events, and changes of conditions.
[[nodiscard]] std::set<NodeId> stepAtoms(const System& system, NodeId node);
/// Whether a node depends on what happens in a step, so that it is more than a condition on a
/// state.
[[nodiscard]] bool watchesSteps(const System& system, NodeId node);

} // namespace proskill::verify
