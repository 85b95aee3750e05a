#include "verify/export/promela_model.h"

#include "verify/export/asked.h"

#include <algorithm>

namespace proskill::verify {

Bits oldCells(const System& system, const Transition& transition, PathId part) {
  Bits cells;
  if (!transition.apart) return cells;
  for (auto other : transition.parts)
    if (other != part) cells |= system.paths[other].writes;
  cells &= system.paths[part].reads;
  return cells;
}

bool needTemporaries(const System& system, const Path& path, const Instruction& instruction) {
  Bits written;
  for (auto i = instruction.first; i < instruction.last; ++i) {
    Bits reads;
    addReads(system, path.assignments[i].value, reads);
    if (reads.meets(written)) return true;
    written.insert(path.assignments[i].target);
  }
  return false;
}

PromelaModel::PromelaModel(Compiled& compiled, const std::vector<std::string>& propertyNames)
    : system(compiled.system),
      nodes(compiled.system),
      faults(nodes, compiled.system),
      names(compiled.system),
      time(compiled.system),
      timed(!compiled.system.clocks.empty()) {
  const auto& s = system;
  mayFail = std::ranges::any_of(s.paths, &Path::mayFail) ||
            std::ranges::any_of(s.transitions, &Transition::fails);
  for (std::size_t i = 0; i < compiled.goals.size(); ++i)
    if (!whyNotAsked(compiled.goals[i])) addAssertion(compiled.goals[i], propertyNames[i]);
  findNamed();
  findCopies();
}

void PromelaModel::addAssertion(const Goal& goal, const std::string& name) {
  auto& made = assertions.emplace_back(names.property(name), name, &goal);
  events |= goal.events;
  if (goal.kind != GoalKind::Condition && goal.kind != GoalKind::Deadlock) return;
  made.condition = faults.value(goal.condition);
  addReads(system, made.condition, made.reads);
  if (!isOfSteps(made)) return;
  addEvents(system, made.condition, eventsOfSteps);
  events |= eventsOfSteps;
  before |= made.reads;
}

/// Those that may block another one or time, that keep a clock running, or that end the run.
void PromelaModel::findNamed() {
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    const auto& transition = system.transitions[i];
    named.insert(transition.blockers.begin(), transition.blockers.end());
    named.insert(transition.laterBlockers.begin(), transition.laterBlockers.end());
    const bool limitsTime = transition.urgent || transition.clock != kNone;
    if (transition.fails || (timed && limitsTime)) named.insert(i);
  }
}

void PromelaModel::findCopies() {
  kept = before;
  for (const auto& transition : system.transitions)
    for (auto part : transition.parts) kept |= oldCells(system, transition, part);
  for (const auto& path : system.paths)
    for (const auto& instruction : path.code)
      if (instruction.kind == InstructionKind::Assign && needTemporaries(system, path, instruction))
        temporaries = std::max<std::size_t>(temporaries, instruction.last - instruction.first);
}

} // namespace proskill::verify
