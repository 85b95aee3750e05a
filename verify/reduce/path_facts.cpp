#include "verify/reduce/path_facts.h"

#include "verify/model/nodes.h"
#include "verify/state/evaluate.h"

#include <algorithm>

namespace proskill::verify {

std::vector<std::uint32_t> targetsOf(const Path& path) {
  std::vector<std::uint32_t> all;
  for (const auto& instruction : path.code) {
    if (instruction.kind == InstructionKind::To) all.push_back(instruction.last);
    if (instruction.kind == InstructionKind::Loop) all.push_back(path.location);
  }
  return all;
}

std::map<std::uint32_t, Bits> surelyWritten(const Path& path, const Bits& allCells) {
  std::vector<Bits> before(path.code.size(), allCells); // not reached: everything
  if (!before.empty()) before[0] = {};
  std::map<std::uint32_t, Bits> atEnd;
  const auto meet = [](Bits& into, const Bits& other) {
    Bits outside = into;
    outside -= other;
    into -= outside;
  };
  for (std::size_t i = 0; i < path.code.size(); ++i) {
    const auto& instruction = path.code[i];
    Bits written = before[i];
    switch (instruction.kind) {
    case InstructionKind::Assign:
    case InstructionKind::Store:
      for (auto at = instruction.first; at < instruction.last; ++at)
        written.insert(path.assignments[at].target);
      break;
    case InstructionKind::JumpUnless: meet(before[instruction.last], written); break;
    case InstructionKind::Jump: meet(before[instruction.last], written); continue;
    case InstructionKind::To:
    case InstructionKind::Loop: {
      bool to = instruction.kind == InstructionKind::To;
      auto [end, first] = atEnd.try_emplace(to ? instruction.last : path.location, written);
      if (!first) meet(end->second, written);
      continue;
    }
    case InstructionKind::On:
    case InstructionKind::Tag:
    case InstructionKind::Origin:
    case InstructionKind::Fail: break;
    }
    if (i + 1 < path.code.size()) meet(before[i + 1], written);
  }
  return atEnd;
}

bool mayPass(const System& system, const Transition& transition, const Bits& events) {
  const auto isOne = [&](EventId event) { return event != kNone && events.contains(event); };
  return std::ranges::any_of(transition.events, isOne) ||
         std::ranges::any_of(transition.parts, [&](PathId part) {
           return std::ranges::any_of(system.paths[part].code, isOne, &Instruction::event);
         });
}

bool mayMakeTrue(const System& system, const Path& path, NodeId condition) {
  Bits cells;
  addReads(system, condition, cells);
  if (!path.writes.meets(cells)) return false;
  if (cells.count() != 1) return true;
  std::vector<Word> trial(system.words);
  return std::ranges::any_of(path.assignments, [&](const Assignment& assignment) {
    if (!cells.contains(assignment.target)) return false;
    const Node& value = system.nodes[assignment.value];
    if (value.op != NodeOp::Number) return true;
    writeCell(system, assignment.target, value.number, trial.data());
    return holds(system, condition, trial.data());
  });
}

bool makesFalse(const System& system, const Path& path, const Bits& sure, NodeId condition) {
  Bits cells;
  addReads(system, condition, cells);
  return cells.count() == 1 && sure.meets(cells) && !mayMakeTrue(system, path, condition);
}

} // namespace proskill::verify
