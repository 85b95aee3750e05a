#include "verify/model/nodes.h"

#include "verify/model/value_bounds.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

namespace {

__extension__ using Wide = __int128;

/// \return nullopt on overflow, which is an error at run time
std::optional<std::int64_t> within(Wide value) {
  if (value < -kLargestNumber || value > kLargestNumber) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

std::optional<std::int64_t> calculate(NodeOp op, std::int64_t a, std::int64_t b) {
  switch (op) {
  case NodeOp::And: return a != 0 && b != 0;
  case NodeOp::Or: return a != 0 || b != 0;
  case NodeOp::Equal: return a == b;
  case NodeOp::Less: return a < b;
  case NodeOp::LessEqual: return a <= b;
  case NodeOp::Add: return within(static_cast<Wide>(a) + b);
  case NodeOp::Subtract: return within(static_cast<Wide>(a) - b);
  case NodeOp::Multiply: return within(static_cast<Wide>(a) * b);
  case NodeOp::Divide: return b == 0 ? std::nullopt : std::optional(a / b);
  case NodeOp::Modulo: return b == 0 ? std::nullopt : std::optional(a % b);
  case NodeOp::Number:
  case NodeOp::Cell:
  case NodeOp::Test:
  case NodeOp::Not:
  case NodeOp::Negate:
  case NodeOp::Conditional:
  case NodeOp::Happens:
  case NodeOp::Entered:
  case NodeOp::Left:
  case NodeOp::Received:
  case NodeOp::Require:
  case NodeOp::Fails: return std::nullopt;
  }
  std::unreachable();
}

/// The other members follow from these.
bool isSame(const Node& one, const Node& other) {
  return one.op == other.op && one.a == other.a && one.b == other.b && one.c == other.c &&
         one.number == other.number;
}

std::uint64_t hashOf(const Node& node) {
  auto hash = mix(0, static_cast<std::uint64_t>(node.op) << 32 | node.a);
  hash = mix(hash, std::uint64_t{node.b} << 32 | node.c);
  hash = mix(hash, static_cast<std::uint64_t>(node.number));
  return mix(hash, hash >> 32);
}

} // namespace

Nodes::Nodes(System& of, const std::function<void()>& check) : system(of) {
  constexpr NodeId kBetweenChecks = 64;
  for (NodeId i = 0; i < system.nodes.size(); ++i) {
    if (check && i % kBetweenChecks == 0) check();
    known.findOrAdd(hashOf(system.nodes[i]), i,
                    [&](NodeId other) { return isSame(system.nodes[other], system.nodes[i]); });
  }
}

NodeId Nodes::make(Node node) {
  const auto next = static_cast<NodeId>(system.nodes.size());
  const auto found = known.findOrAdd(
      hashOf(node), next, [&](NodeId other) { return isSame(system.nodes[other], node); });
  if (found == next) system.nodes.push_back(node);
  return found;
}

NodeId Nodes::number(std::int64_t value) { return make({.op = NodeOp::Number, .number = value}); }

NodeId Nodes::cell(CellId cell) { return make({.op = NodeOp::Cell, .a = cell}); }

NodeId Nodes::happens(EventId event) { return make({.op = NodeOp::Happens, .a = event}); }

std::optional<std::int64_t> Nodes::constant(NodeId node) const {
  if (system.nodes[node].op != NodeOp::Number) return std::nullopt;
  return system.nodes[node].number;
}

NodeId Nodes::unary(NodeOp op, NodeId a) {
  if (auto value = constant(a)) {
    if (op == NodeOp::Not) return number(*value == 0);
    if (op == NodeOp::Negate) return number(-*value);
  }
  if (op == NodeOp::Not && system.nodes[a].op == NodeOp::Not) return system.nodes[a].a;
  return make({.op = op, .a = a});
}

std::optional<NodeId> Nodes::folded(NodeOp op, NodeId a, NodeId b) {
  auto left = constant(a);
  auto right = constant(b);
  if (left && right)
    if (auto value = calculate(op, *left, *right)) return number(*value);
  if (op == NodeOp::And) {
    if (left) return *left != 0 ? b : number(0);
    if (right && *right != 0) return a;
    if (a == b) return a;
  }
  if (op == NodeOp::Or) {
    if (left) return *left != 0 ? number(1) : b;
    if (right && *right == 0) return a;
    if (a == b) return a;
  }
  if (op == NodeOp::Equal && a == b && !mayFail(system, a)) return number(1);
  return std::nullopt;
}

NodeId Nodes::binary(NodeOp op, NodeId a, NodeId b) {
  if (auto simple = folded(op, a, b)) return *simple;
  return make({.op = op, .a = a, .b = b});
}

NodeId Nodes::conditional(NodeId a, NodeId b, NodeId c) {
  if (auto value = constant(a)) return *value != 0 ? b : c;
  if (b == c && !mayFail(system, a)) return b;
  return make({.op = NodeOp::Conditional, .a = a, .b = b, .c = c});
}

NodeId Nodes::require(NodeId a, NodeId b, FaultId fault) {
  if (constant(a).value_or(0) != 0) return b;
  return make({.op = NodeOp::Require, .a = a, .b = b, .c = fault});
}

NodeId Nodes::between(NodeId value, std::int64_t low, std::int64_t high, FaultId fault) {
  const auto inside = both(binary(NodeOp::LessEqual, number(low), value),
                           binary(NodeOp::LessEqual, value, number(high)));
  if (constant(inside).value_or(0) != 0) return value;
  return make({.op = NodeOp::Require,
               .a = inside,
               .b = value,
               .c = fault,
               .number = 1,
               .low = low,
               .high = high});
}

FaultId Nodes::fault(const std::string& words) {
  const auto found = std::ranges::find(system.faults, words);
  if (found != system.faults.end()) return static_cast<FaultId>(found - system.faults.begin());
  system.faults.push_back(words);
  return static_cast<FaultId>(system.faults.size() - 1);
}

NodeId Nodes::substitute(NodeId id, const Leaf& leaf) {
  const Node node = system.nodes[id]; // a copy, since nodes are added
  switch (node.op) {
  case NodeOp::Number:
  case NodeOp::Test: return id;
  case NodeOp::Cell:
  case NodeOp::Happens:
  case NodeOp::Received: return leaf(node).value_or(id);
  case NodeOp::Not:
  case NodeOp::Negate:
  case NodeOp::Fails:
  case NodeOp::Entered:
  case NodeOp::Left: return unary(node.op, substitute(node.a, leaf));
  case NodeOp::Require: {
    const NodeId value = substitute(node.b, leaf);
    return node.number != 0 ? between(value, node.low, node.high, node.c)
                            : require(substitute(node.a, leaf), value, node.c);
  }
  case NodeOp::Conditional:
    return conditional(substitute(node.a, leaf), substitute(node.b, leaf),
                       substitute(node.c, leaf));
  case NodeOp::And:
  case NodeOp::Or:
  case NodeOp::Equal:
  case NodeOp::Less:
  case NodeOp::LessEqual:
  case NodeOp::Add:
  case NodeOp::Subtract:
  case NodeOp::Multiply:
  case NodeOp::Divide:
  case NodeOp::Modulo: return binary(node.op, substitute(node.a, leaf), substitute(node.b, leaf));
  }
  std::unreachable();
}

namespace {

/// Calls `visit` with each node of an expression, including itself.
template <class Visit> void eachNode(const System& system, NodeId id, Visit& visit) {
  const Node& node = system.nodes[id];
  visit(node);
  switch (node.op) {
  case NodeOp::Number:
  case NodeOp::Cell:
  case NodeOp::Test:
  case NodeOp::Received:
  case NodeOp::Happens: return;
  case NodeOp::Not:
  case NodeOp::Negate:
  case NodeOp::Fails:
  case NodeOp::Entered:
  case NodeOp::Left: return eachNode(system, node.a, visit);
  case NodeOp::Conditional: eachNode(system, node.c, visit); [[fallthrough]];
  case NodeOp::And:
  case NodeOp::Or:
  case NodeOp::Equal:
  case NodeOp::Less:
  case NodeOp::LessEqual:
  case NodeOp::Add:
  case NodeOp::Subtract:
  case NodeOp::Multiply:
  case NodeOp::Divide:
  case NodeOp::Modulo:
  case NodeOp::Require: eachNode(system, node.a, visit); eachNode(system, node.b, visit);
  }
}

/// Calls `visit` with each cell that a node reads, perhaps several times.
template <class Visit> void eachRead(const System& system, NodeId id, const Visit& visit) {
  auto visitNode = [&](const Node& node) {
    if (node.op == NodeOp::Cell || node.op == NodeOp::Test)
      visit(node.op == NodeOp::Cell ? node.a : node.b);
  };
  eachNode(system, id, visitNode);
}

} // namespace

void addReads(const System& system, NodeId id, Bits& cells) {
  eachRead(system, id, [&](CellId cell) { cells.insert(cell); });
}

std::vector<CellId> readsOf(const System& system, NodeId id) {
  std::vector<CellId> cells;
  eachRead(system, id, [&](CellId cell) { cells.push_back(cell); });
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

void addEvents(const System& system, NodeId id, Bits& events) {
  auto visit = [&](const Node& node) {
    if (node.op == NodeOp::Happens) events.insert(node.a);
  };
  eachNode(system, id, visit);
}

std::set<NodeId> stepAtoms(const System& system, NodeId id) {
  std::set<NodeId> atoms;
  auto visit = [&](const Node& node) {
    if (node.op == NodeOp::Happens || node.op == NodeOp::Entered || node.op == NodeOp::Left)
      atoms.insert(static_cast<NodeId>(&node - system.nodes.data()));
  };
  eachNode(system, id, visit);
  return atoms;
}

bool watchesSteps(const System& system, NodeId id) { return !stepAtoms(system, id).empty(); }

} // namespace proskill::verify
