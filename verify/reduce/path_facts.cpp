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

std::map<std::uint32_t, Bits> surelyWritten(const Path& path) {
  return alongPath(
      path, Bits{},
      [](Bits& written, const Assignment& assignment) { written.insert(assignment.target); },
      [](Bits& written, const Bits& other) {
        if (written.isWithin(other)) return false;
        written &= other;
        return true;
      });
}

bool mayBeAnError(const System& system, TransitionId id) {
  const Transition& transition = system.transitions[id];
  return transition.fails || std::ranges::any_of(transition.parts, [&](PathId part) {
           return system.paths[part].mayFail || system.paths[part].fails;
         });
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
