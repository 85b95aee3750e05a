#include "verify/export/promela_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace proskill::verify {

namespace {

class PathText {
public:
  PathText(PromelaModel& in, TransitionId which, std::size_t part)
      : model(in),
        id(which),
        index(part),
        path(in.system.paths[in.system.transitions[which].parts[part]]),
        old(oldCells(in.system, in.system.transitions[which],
                     in.system.transitions[which].parts[part])) {}

  std::vector<std::string> write() {
    for (std::size_t i = 0; i < path.code.size(); ++i) findTargets(i);
    if (hasLoop) lines.emplace_back("turns = 0");
    for (std::size_t i = 0; i < path.code.size(); ++i) {
      if (targets.contains(i)) lines.push_back(fmt::format("{}: skip", label(i)));
      write(i);
    }
    if (targets.contains(path.code.size()))
      lines.push_back(fmt::format("{}: skip", label(path.code.size())));
    return std::move(lines);
  }

private:
  [[nodiscard]] bool isEnd(std::size_t at) const {
    const auto kind = path.code[at].kind;
    return kind == InstructionKind::To || kind == InstructionKind::Loop;
  }

  void findTargets(std::size_t at) {
    const auto& it = path.code[at];
    if (it.kind == InstructionKind::Jump || it.kind == InstructionKind::JumpUnless)
      targets.insert(it.last);
    hasLoop = hasLoop || (it.kind == InstructionKind::Jump && it.last <= at);
    if (isEnd(at) && at + 1 < path.code.size()) targets.insert(path.code.size());
  }

  [[nodiscard]] std::string label(std::size_t at) const {
    return fmt::format("L{}_{}_{}", id, index, at);
  }

  [[nodiscard]] std::string text(NodeId node) const { return model.names.text(node, old); }

  void failIf(NodeId condition) {
    if (model.nodes.constant(condition) == 0) return;
    lines.push_back(fmt::format("if :: {} -> fail_run; goto E{} :: else fi", text(condition), id));
  }

  void write(std::size_t at) {
    const Instruction it = path.code[at];
    switch (it.kind) {
    case InstructionKind::Assign: return assign(it);
    case InstructionKind::On: return failIf(model.faults.fault(it.node)); // it holds: see the guard
    case InstructionKind::JumpUnless:
      failIf(model.faults.fault(it.node));
      lines.push_back(fmt::format("if :: {} -> skip :: else -> goto {} fi",
                                  text(model.faults.value(it.node)), label(it.last)));
      return;
    case InstructionKind::Jump: return jump(it, at);
    case InstructionKind::Tag: return happen(it.event);
    case InstructionKind::Fail: lines.push_back(fmt::format("fail_run; goto E{}", id)); return;
    case InstructionKind::To:
      lines.push_back(fmt::format(
          "{} = {}", model.names.cell(model.system.instances[path.instance].location), it.last));
      happen(it.event);
      [[fallthrough]];
    case InstructionKind::Loop:
      if (at + 1 < path.code.size())
        lines.push_back(fmt::format("goto {}", label(path.code.size())));
      return;
    case InstructionKind::Origin: return;
    case InstructionKind::Store: break; // there is no layout yet
    }
    std::unreachable();
  }

  void jump(const Instruction& it, std::size_t at) {
    if (it.last <= at)
      lines.push_back(
          fmt::format("turns++; if :: turns > 100000 -> fail_run; goto E{} :: else fi", id));
    lines.push_back(fmt::format("goto {}", label(it.last)));
  }

  void happen(EventId event) {
    if (event != kNone && model.events.contains(event))
      lines.push_back(fmt::format("{} = 1", model.names.event(event)));
  }

  void assign(const Instruction& it) {
    const bool atOnce = !needTemporaries(model.system, path, it);
    std::vector<std::string> writes;
    for (auto i = it.first; i < it.last; ++i) {
      const auto& assignment = path.assignments[i];
      failIf(model.faults.fault(assignment.value));
      const NodeId value = model.faults.value(assignment.value);
      if (assignment.checked) failIf(isOutside(assignment.target, value));
      const auto& target = model.names.cell(assignment.target);
      const auto temporary = fmt::format("n{}", i - it.first);
      if (!atOnce) lines.push_back(fmt::format("{} = {}", temporary, text(value)));
      writes.push_back(fmt::format("{} = {}", target, atOnce ? text(value) : temporary));
    }
    std::ranges::move(writes, std::back_inserter(lines));
  }

  NodeId isOutside(CellId cell, NodeId value) {
    auto& nodes = model.nodes;
    const Cell& bounds = model.system.cells[cell];
    return nodes.binary(NodeOp::Or, nodes.binary(NodeOp::Less, value, nodes.number(bounds.low)),
                        nodes.binary(NodeOp::Less, nodes.number(bounds.high), value));
  }

  PromelaModel& model;
  TransitionId id;
  std::size_t index;
  const Path& path;
  Bits old; ///< cells that are read as they were before the step
  std::set<std::size_t> targets;
  bool hasLoop = false;
  std::vector<std::string> lines;
};

} // namespace

std::vector<std::string> promelaPath(PromelaModel& model, TransitionId id, std::size_t part) {
  return PathText(model, id, part).write();
}

} // namespace proskill::verify
