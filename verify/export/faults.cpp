#include "verify/export/faults.h"

#include "verify/model/value_bounds.h"

#include <utility>

namespace proskill::verify {

NodeId Faults::both(NodeId a, NodeId b) {
  if (nodes.constant(b) == 0 || areOpposite(a, b)) return nodes.number(0);
  return nodes.both(a, b);
}

/// The branches of an `if` meet again after it, with conditions such as `r and a` and `r and not
/// a`.
NodeId Faults::either(NodeId a, NodeId b) {
  if (nodes.constant(b).value_or(0) != 0 || areOpposite(a, b)) return nodes.number(1);
  const Node one = system.nodes[a];
  const Node other = system.nodes[b];
  if (other.op != NodeOp::And) return nodes.binary(NodeOp::Or, a, b);
  if (areOpposite(a, other.a)) return either(a, other.b);
  if (one.op != NodeOp::And || one.a != other.a) return nodes.binary(NodeOp::Or, a, b);
  return both(one.a, either(one.b, other.b));
}

/// Whether one is the negation of the other, as far as their forms show.
bool Faults::areOpposite(NodeId a, NodeId b) const {
  const Node& one = system.nodes[a];
  const Node& other = system.nodes[b];
  if ((one.op == NodeOp::Not && one.a == b) || (other.op == NodeOp::Not && other.a == a))
    return true;
  const bool isDual = (one.op == NodeOp::And && other.op == NodeOp::Or) ||
                      (one.op == NodeOp::Or && other.op == NodeOp::And);
  return isDual && areOpposite(one.a, other.a) && areOpposite(one.b, other.b);
}

NodeId Faults::value(NodeId id) {
  if (const auto known = values.find(id); known != values.end()) return known->second;
  const Node node = system.nodes[id]; // a copy, since nodes are added
  return values[id] = valueOf(node);
}

NodeId Faults::valueOf(const Node& node) {
  switch (node.op) {
  case NodeOp::Number: return nodes.number(node.number);
  case NodeOp::Cell: return nodes.cell(node.a);
  case NodeOp::Happens: return nodes.happens(node.a);
  case NodeOp::Require: return value(node.b);
  case NodeOp::Fails: return fault(node.a);
  case NodeOp::Not:
  case NodeOp::Negate:
  case NodeOp::Entered:
  case NodeOp::Left: return nodes.unary(node.op, value(node.a));
  case NodeOp::Conditional: return nodes.conditional(value(node.a), value(node.b), value(node.c));
  case NodeOp::And:
  case NodeOp::Or:
  case NodeOp::Equal:
  case NodeOp::Less:
  case NodeOp::LessEqual:
  case NodeOp::Add:
  case NodeOp::Subtract:
  case NodeOp::Multiply:
  case NodeOp::Divide:
  case NodeOp::Modulo: return nodes.binary(node.op, value(node.a), value(node.b));
  case NodeOp::Test:
  case NodeOp::Received: break; // not in compiled systems that have no layout yet
  }
  std::unreachable();
}

NodeId Faults::fault(NodeId id) {
  if (const auto known = faults.find(id); known != faults.end()) return known->second;
  if (!mayFail(system, id)) return faults[id] = nodes.number(0);
  const Node node = system.nodes[id];
  return faults[id] = faultOf(node);
}

/// In the order of evaluation: the second operand of `and` and `or` may never be evaluated.
NodeId Faults::faultOf(const Node& node) {
  switch (node.op) {
  case NodeOp::Not:
  case NodeOp::Negate:
  case NodeOp::Entered:
  case NodeOp::Left: return fault(node.a);
  case NodeOp::And: return either(fault(node.a), both(value(node.a), fault(node.b)));
  case NodeOp::Or: return either(fault(node.a), both(nodes.negation(value(node.a)), fault(node.b)));
  case NodeOp::Equal:
  case NodeOp::Less:
  case NodeOp::LessEqual:
  case NodeOp::Add:
  case NodeOp::Subtract:
  case NodeOp::Multiply: return either(fault(node.a), fault(node.b));
  case NodeOp::Divide:
  case NodeOp::Modulo:
    return either(either(fault(node.a), fault(node.b)),
                  nodes.equal(value(node.b), nodes.number(0)));
  case NodeOp::Conditional:
    return either(fault(node.a), nodes.conditional(value(node.a), fault(node.b), fault(node.c)));
  case NodeOp::Require:
    return either(either(fault(node.a), nodes.negation(value(node.a))), fault(node.b));
  case NodeOp::Number:
  case NodeOp::Cell:
  case NodeOp::Test:
  case NodeOp::Happens:
  case NodeOp::Received:
  case NodeOp::Fails: return nodes.number(0);
  }
  std::unreachable();
}

} // namespace proskill::verify
