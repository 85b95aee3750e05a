#include "verify/slice/part_text.h"

#include <algorithm>

namespace proskill::verify {

PartText::PartText(const System& slice) : system(slice) {
  for (const auto& transition : system.transitions) putTransition(transition);
}

std::string PartText::with(const Goal& goal) const {
  PartText whole = *this;
  whole.putGoal(goal);
  return std::move(whole.bytes);
}

void PartText::put(std::int64_t number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void PartText::put(const fiacre::Interval& interval) {
  put(interval.lower);
  put(interval.lowerOpen ? 1 : 0);
  put(interval.upper ? *interval.upper : -1);
  put(interval.upperOpen ? 1 : 0);
}

bool PartText::putNumber(Numbers& numbers, std::uint32_t id) {
  if (id == kNone) {
    put(-1);
    return false;
  }
  if (id >= numbers.of.size()) numbers.of.resize(id + 1, kNone);
  const bool isNew = numbers.of[id] == kNone;
  if (isNew) numbers.of[id] = numbers.count++;
  put(numbers.of[id]);
  return isNew;
}

void PartText::putCell(CellId id) {
  if (!putNumber(cells, id)) return;
  const Cell& cell = system.cells[id];
  for (auto value : {cell.low, cell.high, cell.initial}) put(value);
}

/// The meaning of `a`, `b` and `c` depends on the kind of the node.
void PartText::putNode(NodeId id) {
  if (!putNumber(nodes, id)) return;
  const Node& node = system.nodes[id];
  for (auto value : {static_cast<std::int64_t>(node.op), node.number, node.low, node.high})
    put(value);
  switch (node.op) {
  case NodeOp::Number:
  case NodeOp::Test: break;
  case NodeOp::Received: put(node.a); break;
  case NodeOp::Cell: putCell(node.a); break;
  case NodeOp::Happens: putEvent(node.a); break;
  case NodeOp::Not:
  case NodeOp::Negate:
  case NodeOp::Entered:
  case NodeOp::Left:
  case NodeOp::Fails: putNode(node.a); break;
  case NodeOp::Conditional: putNode(node.c); [[fallthrough]];
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
  case NodeOp::Require:
    putNode(node.a);
    putNode(node.b);
    break;
  }
}

void PartText::putEvent(EventId id) { putNumber(events, id); }

void PartText::putInstance(InstanceId id) {
  if (!putNumber(instances, id)) return;
  putCell(system.instances[id].location);
  put(static_cast<std::int64_t>(system.instances[id].locations.size()));
}

void PartText::putClock(ClockId id) {
  if (!putNumber(clocks, id)) return;
  putNumber(instances, system.clocks[id].instance);
}

void PartText::putPath(PathId id) {
  if (putNumber(paths, id)) putContent(system.paths[id]);
}

void PartText::putContent(const Path& path) {
  putInstance(path.instance);
  for (auto flag : {path.tentative, path.loops, path.receives, path.mayFail, path.fails})
    put(flag ? 1 : 0);
  for (auto number : {path.location, path.group, path.select}) put(number);
  putNode(path.guard);
  for (auto list : {path.sent.size(), path.risks.size(), path.code.size()})
    put(static_cast<std::int64_t>(list));
  for (auto node : path.sent) putNode(node);
  for (const auto& risk : path.risks) {
    putNode(risk.node);
    putNode(risk.value);
  }
  putCode(path);
}

/// Instructions are numbered within the path, so jumps need no translation.
void PartText::putCode(const Path& path) {
  for (const auto& instruction : path.code) {
    put(static_cast<std::int64_t>(instruction.kind));
    switch (instruction.kind) {
    case InstructionKind::Assign:
    case InstructionKind::Store:
    case InstructionKind::To:
    case InstructionKind::Loop:
      put(instruction.first);
      put(instruction.last);
      break;
    case InstructionKind::JumpUnless:
    case InstructionKind::Jump: put(instruction.last); break;
    case InstructionKind::On:
    case InstructionKind::Tag:
    case InstructionKind::Origin:
    case InstructionKind::Fail: break;
    }
    putNode(instruction.node);
    putEvent(instruction.event);
  }
  put(static_cast<std::int64_t>(path.assignments.size()));
  for (const auto& assignment : path.assignments) {
    putCell(assignment.target);
    putNode(assignment.value);
    put(assignment.checked ? 1 : 0);
  }
}

void PartText::putTransition(const Transition& transition) {
  for (auto list : {transition.parts.size(), transition.events.size(), transition.seen.size()})
    put(static_cast<std::int64_t>(list));
  for (auto part : transition.parts) putPath(part);
  for (auto event : transition.events) putEvent(event);
  for (auto node : transition.seen) putNode(node);
  for (auto flag : {transition.urgent, transition.tentative, transition.fails, transition.apart})
    put(flag ? 1 : 0);
  put(transition.interval);
  putClock(transition.clock);
  putNode(transition.guard);
  put(transition.consumed.count());
  transition.consumed.each([&](InstanceId instance) { putInstance(instance); });
}

/// Events that the slice does not contain never happen in it.
void PartText::putGoal(const Goal& goal) {
  put(static_cast<std::int64_t>(goal.kind));
  put(goal.ofSteps ? 1 : 0);
  put(goal.initially ? 1 : 0);
  std::vector<std::uint32_t> known;
  goal.events.each([&](EventId event) {
    if (event < events.of.size() && events.of[event] != kNone) known.push_back(events.of[event]);
  });
  std::ranges::sort(known);
  put(static_cast<std::int64_t>(known.size()));
  for (auto event : known) put(event);
  putNode(goal.condition);
  putMonitor(goal.monitor);
}

void PartText::putMonitor(const Monitor& monitor) {
  put(static_cast<std::int64_t>(monitor.locations.size()));
  for (const auto& location : monitor.locations) {
    putNode(location.stay);
    for (auto flag : {location.timed, location.accepting, location.error}) put(flag ? 1 : 0);
    put(static_cast<std::int64_t>(location.edges.size()));
    for (const auto& edge : location.edges) {
      put(edge.to);
      putNode(edge.condition);
      put(edge.clock.lower);
      put(edge.clock.upper);
      for (auto flag : {edge.ofStep, edge.reset}) put(flag ? 1 : 0);
    }
  }
  put(static_cast<std::int64_t>(monitor.initial.size()));
  for (auto location : monitor.initial) put(location);
  for (auto flag : {monitor.ofPoints, monitor.ofStates, monitor.fair, monitor.rests})
    put(flag ? 1 : 0);
}

} // namespace proskill::verify
