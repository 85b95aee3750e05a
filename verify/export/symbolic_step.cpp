#include "verify/export/symbolic_step.h"

#include "verify/model/conjuncts.h"
#include "verify/unsupported.h"

#include <utility>

namespace proskill::verify {

namespace {

/// A point of the code: when it is reached, and the values of the cells there.
struct Point {
  NodeId reached = 0;
  std::map<CellId, NodeId> values;
};

class Execution {
public:
  Execution(const System& of, Nodes& to, Faults& in) : system(of), nodes(to), faults(in) {
    step.gaveUp = nodes.number(0);
    step.finished = nodes.number(1);
  }

  /// Executes a part, whose code reads the state before the step.
  void run(const Path& path) {
    points.assign(path.code.size() + 1, std::nullopt);
    points[0] = Point{step.finished, {}};
    for (std::uint32_t i = 0; i < path.code.size(); ++i)
      if (points[i]) run(path, i);
    const auto& end = points.back();
    step.finished = end ? end->reached : nodes.number(0);
    if (!end) return;
    for (const auto& [cell, value] : end->values) step.after[cell] = value;
  }

  SymbolicStep step;

private:
  void run(const Path& path, std::uint32_t at) {
    const auto& instruction = path.code[at];
    Point here = *std::move(points[at]);
    switch (instruction.kind) {
    case InstructionKind::Assign: assign(path, instruction, here); break;
    case InstructionKind::On: test(instruction, here); break;
    case InstructionKind::JumpUnless: return branch(path, instruction, std::move(here), at);
    case InstructionKind::Jump: return reach(path, at, instruction.last, std::move(here));
    case InstructionKind::Fail: return;
    case InstructionKind::Tag: note(instruction.event, here); break;
    case InstructionKind::Origin: break;
    case InstructionKind::To:
      here.values[system.instances[path.instance].location] = nodes.number(instruction.last);
      note(instruction.event, here);
      return reach(path, at, end(path), std::move(here));
    case InstructionKind::Loop: return reach(path, at, end(path), std::move(here));
    case InstructionKind::Store: std::unreachable(); // there is no layout yet
    }
    reach(path, at, at + 1, std::move(here));
  }

  static std::uint32_t end(const Path& path) {
    return static_cast<std::uint32_t>(path.code.size());
  }

  void assign(const Path& path, const Instruction& instruction, Point& here) {
    auto next = here.values;
    for (auto i = instruction.first; i < instruction.last; ++i) {
      const auto& assignment = path.assignments[i];
      const NodeId value = now(assignment.value, here);
      goOn(nodes.negation(faults.fault(value)), here);
      const NodeId plain = faults.value(value);
      if (assignment.checked) goOn(fits(assignment.target, plain), here);
      next[assignment.target] = plain;
    }
    here.values = std::move(next);
  }

  NodeId fits(CellId cell, NodeId value) {
    const auto& bounds = system.cells[cell];
    return faults.both(nodes.binary(NodeOp::LessEqual, nodes.number(bounds.low), value),
                       nodes.binary(NodeOp::LessEqual, value, nodes.number(bounds.high)));
  }

  void test(const Instruction& instruction, Point& here) {
    const NodeId condition = now(instruction.node, here);
    goOn(nodes.negation(faults.fault(condition)), here);
    const NodeId holds = faults.value(condition);
    step.gaveUp = faults.either(step.gaveUp, faults.both(here.reached, nodes.negation(holds)));
    goOn(holds, here);
  }

  void branch(const Path& path, const Instruction& instruction, Point here, std::uint32_t at) {
    const NodeId condition = now(instruction.node, here);
    goOn(nodes.negation(faults.fault(condition)), here);
    const NodeId holds = faults.value(condition);
    Point other = here;
    goOn(nodes.negation(holds), other);
    goOn(holds, here);
    reach(path, at, at + 1, std::move(here));
    reach(path, at, instruction.last, std::move(other));
  }

  void goOn(NodeId condition, Point& here) { here.reached = faults.both(here.reached, condition); }

  void note(EventId event, const Point& here) {
    if (event == kNone) return;
    const auto [entry, added] = step.happens.try_emplace(event, here.reached);
    if (!added) entry->second = faults.either(entry->second, here.reached);
  }

  NodeId now(NodeId node, const Point& here) {
    return nodes.substitute(node, [&](const Node& leaf) -> std::optional<NodeId> {
      const auto found = leaf.op == NodeOp::Cell ? here.values.find(leaf.a) : here.values.end();
      return found == here.values.end() ? std::nullopt : std::optional(found->second);
    });
  }

  /// Joins what comes to a point on several ways: at most one of them is taken.
  void reach(const Path& path, std::uint32_t from, std::uint32_t to, Point point) {
    if (to <= from) unsupported("a condition that depends on a loop", path.origin);
    auto& known = points[to];
    if (!known) {
      known = std::move(point);
      return;
    }
    for (const auto& [cell, value] : point.values)
      known->values.try_emplace(cell, nodes.cell(cell));
    for (auto& [cell, value] : known->values) {
      const auto other = point.values.find(cell);
      value = nodes.conditional(known->reached, value,
                                other == point.values.end() ? nodes.cell(cell) : other->second);
    }
    known->reached = faults.either(known->reached, point.reached);
  }

  const System& system;
  Nodes& nodes;
  Faults& faults;
  std::vector<std::optional<Point>> points; ///< by instruction, and the end
};

/// A condition of observers over the step and the states around it.
NodeId overStep(const System& system, NodeId id, const SymbolicStep& step, Nodes& nodes,
                Faults& faults) {
  const Node node = system.nodes[id];
  const auto part = [&](NodeId of) { return overStep(system, of, step, nodes, faults); };
  const auto after = [&](NodeId of) {
    return nodes.substitute(faults.value(of), [&](const Node& leaf) -> std::optional<NodeId> {
      const auto found = leaf.op == NodeOp::Cell ? step.after.find(leaf.a) : step.after.end();
      return found == step.after.end() ? std::nullopt : std::optional(found->second);
    });
  };
  switch (node.op) {
  case NodeOp::Happens: {
    const auto found = step.happens.find(node.a);
    return found == step.happens.end() ? nodes.number(0) : found->second;
  }
  case NodeOp::Entered: return faults.both(nodes.negation(faults.value(node.a)), after(node.a));
  case NodeOp::Left: return faults.both(faults.value(node.a), nodes.negation(after(node.a)));
  case NodeOp::Not: return nodes.negation(part(node.a));
  case NodeOp::And:
  case NodeOp::Or: return nodes.binary(node.op, part(node.a), part(node.b));
  case NodeOp::Number:
  case NodeOp::Cell:
  case NodeOp::Test:
  case NodeOp::Negate:
  case NodeOp::Equal:
  case NodeOp::Less:
  case NodeOp::LessEqual:
  case NodeOp::Add:
  case NodeOp::Subtract:
  case NodeOp::Multiply:
  case NodeOp::Divide:
  case NodeOp::Modulo:
  case NodeOp::Conditional:
  case NodeOp::Received:
  case NodeOp::Require:
  case NodeOp::Fails: return faults.value(id);
  }
  std::unreachable();
}

} // namespace

SymbolicStep symbolicStep(const System& system, const Transition& transition, Nodes& nodes,
                          Faults& faults) {
  Execution execution(system, nodes, faults);
  for (auto event : transition.events) execution.step.happens[event] = nodes.number(1);
  for (auto part : transition.parts) execution.run(system.paths[part]);
  return std::move(execution.step);
}

NodeId enabledNode(const System& system, const Transition& transition, Nodes& nodes,
                   Faults& faults) {
  NodeId enabled = nodes.number(1);
  for (auto conjunct : conjunctsOf(system, transition.guard))
    enabled = faults.both(enabled, faults.condition(conjunct));
  if (!transition.tentative) return enabled;
  const auto step = symbolicStep(system, transition, nodes, faults);
  enabled = faults.both(enabled, nodes.negation(step.gaveUp));
  for (auto condition : transition.seen) {
    const NodeId seen = overStep(system, condition, step, nodes, faults);
    // an error of the model is enabled, too
    enabled = faults.both(enabled, faults.either(nodes.negation(step.finished), seen));
  }
  return enabled;
}

} // namespace proskill::verify
