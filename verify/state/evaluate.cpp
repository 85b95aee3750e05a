#include "verify/state/evaluate.h"

namespace proskill::verify {

namespace {

void fail(FaultId& fault, FaultId with) {
  if (fault == kNoFault) fault = with;
}

std::int64_t quotient(std::int64_t a, std::int64_t b, FaultId& fault) {
  if (b == 0) fail(fault, kDivisionByZero);
  return b == 0 ? 0 : a / b;
}

std::int64_t remainder(std::int64_t a, std::int64_t b, FaultId& fault) {
  if (b == 0) fail(fault, kDivisionByZero);
  return b == 0 ? 0 : a % b;
}

constexpr std::int64_t kLargest = std::int64_t{1} << 62;

std::int64_t fitting(bool overflows, std::int64_t value, FaultId& fault) {
  const bool fits = !overflows && -kLargest <= value && value <= kLargest;
  if (!fits) fail(fault, kOverflow);
  return fits ? value : 0;
}

std::int64_t sum(std::int64_t a, std::int64_t b, FaultId& fault) {
  std::int64_t value = 0;
  const bool overflows = __builtin_add_overflow(a, b, &value);
  return fitting(overflows, value, fault);
}

std::int64_t gap(std::int64_t a, std::int64_t b, FaultId& fault) {
  std::int64_t value = 0;
  const bool overflows = __builtin_sub_overflow(a, b, &value);
  return fitting(overflows, value, fault);
}

std::int64_t product(std::int64_t a, std::int64_t b, FaultId& fault) {
  std::int64_t value = 0;
  const bool overflows = __builtin_mul_overflow(a, b, &value);
  return fitting(overflows, value, fault);
}

/// Evaluation for both kinds of states: `leaf` reads or tests a cell.
template <class Leaf, class Steps>
std::int64_t walk(const System& system, NodeId id, const Leaf& leaf, const Steps& steps,
                  FaultId& fault) {
  const Node& node = system.nodes[id];
  const auto at = [&](NodeId child) { return walk(system, child, leaf, steps, fault); };
  switch (node.op) {
  case NodeOp::Number: return node.number;
  case NodeOp::Cell:
  case NodeOp::Test: return leaf(node);
  case NodeOp::Not: return at(node.a) == 0;
  case NodeOp::Negate: return -at(node.a);
  case NodeOp::And: return at(node.a) != 0 && at(node.b) != 0;
  case NodeOp::Or: return at(node.a) != 0 || at(node.b) != 0;
  case NodeOp::Equal: return at(node.a) == at(node.b);
  case NodeOp::Less: return at(node.a) < at(node.b);
  case NodeOp::LessEqual: return at(node.a) <= at(node.b);
  case NodeOp::Add: return sum(at(node.a), at(node.b), fault);
  case NodeOp::Subtract: return gap(at(node.a), at(node.b), fault);
  case NodeOp::Multiply: return product(at(node.a), at(node.b), fault);
  case NodeOp::Divide: return quotient(at(node.a), at(node.b), fault);
  case NodeOp::Modulo: return remainder(at(node.a), at(node.b), fault);
  case NodeOp::Conditional: return at(node.a) != 0 ? at(node.b) : at(node.c);
  case NodeOp::Happens: return steps.event(node.a);
  case NodeOp::Entered:
  case NodeOp::Left: return steps.change(node, fault);
  case NodeOp::Received: return 0; // replaced before the exploration
  case NodeOp::Require:
    if (at(node.a) != 0) return at(node.b);
    fail(fault, node.c);
    return 0;
  case NodeOp::Fails: {
    FaultId inner = kNoFault;
    walk(system, node.a, leaf, steps, inner);
    return inner != kNoFault;
  }
  }
  return 0;
}

struct PackedLeaf {
  const System& system;
  const Word* state;

  std::int64_t operator()(const Node& node) const {
    if (node.op == NodeOp::Test) return (state[node.a] & node.mask) == node.value;
    return readCell(system, node.a, state);
  }
};

/// Outside of goals there are no steps.
struct NoSteps {
  static std::int64_t event(EventId) { return 0; }
  static std::int64_t change(const Node&, FaultId&) { return 0; }
};

/// The events and changes of a step.
struct MomentSteps {
  const System& system;
  const Moment& moment;

  [[nodiscard]] std::int64_t event(EventId id) const {
    return moment.events && moment.events->contains(id);
  }
  std::int64_t change(const Node& node, FaultId& fault) const {
    if (!moment.after) return 0;
    const auto now = [&](const Word* state) {
      Moment still{state, nullptr, nullptr};
      return walk(system, node.a, PackedLeaf{system, state}, MomentSteps{system, still}, fault) !=
             0;
    };
    bool after = now(moment.after);
    bool before = now(moment.before);
    return node.op == NodeOp::Entered ? !before && after : before && !after;
  }
};

struct PlainLeaf {
  const System& system;
  const std::vector<std::int64_t>& values;

  std::int64_t operator()(const Node& node) const {
    return node.op == NodeOp::Cell ? values.at(node.a) : 0;
  }
};

} // namespace

std::int64_t evaluate(const System& system, NodeId node, const Word* state, FaultId& fault) {
  return walk(system, node, PackedLeaf{system, state}, NoSteps{}, fault);
}

bool holdsAt(const System& system, NodeId node, const Moment& moment) {
  FaultId fault = kNoFault;
  return walk(system, node, PackedLeaf{system, moment.before}, MomentSteps{system, moment},
              fault) != 0;
}

std::optional<std::int64_t> evaluateUnpacked(const System& system, NodeId node,
                                             const std::vector<std::int64_t>& values) {
  FaultId fault = kNoFault;
  auto value = walk(system, node, PlainLeaf{system, values}, NoSteps{}, fault);
  return fault != kNoFault ? std::nullopt : std::optional(value);
}

} // namespace proskill::verify
