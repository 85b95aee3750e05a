#include "analysis/flow/engine/solver.h"

/// The knowledge of a process during its calls, at their returns, and when they are stopped.
namespace proskill::analysis::flow {

State Solver::project(const State& state, const Process& from, const Process& to) const {
  State result{.reachable = state.reachable, .values = {}};
  if (!state.reachable) return result;
  for (VariableId variable : to.slots.variables()) {
    auto slot = from.slots.find(variable);
    result.values.push_back(slot ? state.values[*slot] : anything(variable));
  }
  return result;
}

/// The call first resets the skill's status and result; its preconditions see them reset.
State Solver::entryOf(const State& before, ProcessId caller, NodeId call) const {
  const Process& self = model[caller];
  const Process& callee = model[self.actions[call].target];
  State entry = project(before, self, callee);
  if (!entry.reachable) return entry;
  for (VariableKind kind : {VariableKind::Status, VariableKind::Result})
    if (auto slot = callee.slots.find(model.variables().of(kind, callee.definition)))
      entry.values[*slot] = ValueSet::of(0);
  return entry;
}

State Solver::during(const State& before, ProcessId process, NodeId node) const {
  State state = before;
  if (!state.reachable) return state;
  for (const auto& [slot, relation] : whileCalling[process][node])
    state.values[slot] = relation->closure(state.values[slot]);
  return state;
}

State Solver::during(ProcessId process, NodeId node) const {
  State all;
  for (const State& before : cases(process, node)) all.join(during(before, process, node));
  return all;
}

std::vector<State> Solver::atCallee(ProcessId caller, NodeId call) const {
  std::vector<State> entries;
  for (const State& before : cases(caller, call)) entries.push_back(entryOf(before, caller, call));
  return entries;
}

/// A call resets the outcome of the last run.
void Solver::enter(ProcessId process, State state) {
  if (!state.reachable) return;
  if (model[process].kind == ProcessKind::Skill) {
    set(state, process, VariableKind::Status, static_cast<unsigned>(Status::None));
    set(state, process, VariableKind::Result, 0);
    set(state, process, VariableKind::Called, 1);
  }
  arrive(process, 0, std::move(state));
}

bool Solver::entersCall(const State& before, ProcessId process, NodeId id) const {
  const Process& callee = model[model[process].actions[id].target];
  State entry = entryOf(before, process, id);
  refineAll(entry, callee.actions[0].conditions, true);
  return entry.reachable;
}

/// The state after a call that was served: the intersection of what is known for this return of the
/// callee, and for everything that may have happened since the call.
State Solver::returned(const State& before, const State& exit, ProcessId process, NodeId id) const {
  const Process& self = model[process];
  const Process& callee = model[self.actions[id].target];
  State state = during(before, process, id);
  for (Slot slot = 0; slot < callee.slots.size(); ++slot) {
    auto mine = self.slots.find(callee.slots[slot]);
    if (!mine) continue;
    state.values[*mine] &= rely[process].relations[*mine]->closure(exit.values[slot]);
    if (state.values[*mine].empty()) return {};
  }
  return state;
}

State Solver::refused(const State& before, ProcessId process, NodeId id) const {
  const Process& self = model[process];
  const Process& callee = model[self.actions[id].target];
  if (callee.actions[0].conditions.empty()) return {};
  State entry = entryOf(before, process, id);
  refineAll(entry, callee.actions[0].conditions, false);
  if (!entry.reachable) return {};
  State state = before;
  for (Slot slot = 0; slot < callee.slots.size(); ++slot)
    if (auto mine = self.slots.find(callee.slots[slot])) state.values[*mine] = entry.values[slot];
  for (VariableKind kind : {VariableKind::Status, VariableKind::Result, VariableKind::Called})
    if (auto slot = self.slots.find(model.variables().of(kind, callee.definition)))
      state.values[*slot] = ValueSet::of(0);
  return state;
}

void Solver::call(ProcessId process, NodeId id, NodeId next) {
  ProcessId target = model[process].actions[id].target;
  const std::vector<State> all = cases(process, id);
  for (const State& before : all) enter(target, project(before, model[process], model[target]));
  const std::vector<State> ends = cases(target, model[target].graph->end);
  for (const State& before : all) {
    arrive(process, next, refused(before, process, id));
    if (!entersCall(before, process, id) && !interrupted[target]) continue;
    for (const State& end : ends) arrive(process, next, returned(before, end, process, id));
  }
}

/// A caller that is stopped waits for its callee to return. The callee may have ended in any way,
/// or was refused, or has not started.
void Solver::stopCall(ProcessId process, NodeId id, NodeId exit) {
  const Process& self = model[process];
  ProcessId target = self.actions[id].target;
  const std::vector<State> all = cases(process, id);
  std::vector<State> ends = cases(target, model[target].graph->end);
  const auto& more = stoppedEnds[target].all();
  ends.insert(ends.end(), more.begin(), more.end());
  auto mayBe = [&](VariableKind kind, unsigned value, State& state) {
    if (auto slot = self.slots.find(model.variables().of(kind, model[target].definition)))
      state.values[*slot] |= ValueSet::of(value);
  };
  for (const State& before : all) {
    State early = before;
    mayBe(VariableKind::Status, static_cast<unsigned>(Status::Interrupted), early);
    mayBe(VariableKind::Result, 0, early);
    mayBe(VariableKind::Called, 0, early);
    arrive(process, exit, std::move(early));
    arrive(process, exit, refused(before, process, id));
    for (const State& end : ends) arrive(process, exit, returned(before, end, process, id));
  }
}

/// Combines what is known with the end of the branch.
Cases Solver::endedBranch(const Cases& known, ProcessId process, ProcessId branch) const {
  const Process& self = model[process];
  const Process& thread = model[branch];
  Cases result;
  for (const State& each : known.all())
    for (const State& end : cases(branch, thread.graph->end)) {
      State both = each;
      for (Slot slot = 0; both.reachable && slot < thread.slots.size(); ++slot) {
        auto mine = self.slots.find(thread.slots[slot]);
        if (!mine) continue;
        both.values[*mine] &= end.values[slot];
        both.reachable = !both.values[*mine].empty();
      }
      result.add(std::move(both), mostCases);
    }
  return result;
}

/// After all branches; for a race, after the end of one of them.
Cases Solver::joined(const State& before, ProcessId process, NodeId id) const {
  const Process& self = model[process];
  Cases during;
  during.add(this->during(before, process, id), mostCases);
  if (!(*self.graph)[id].isRace()) {
    for (ProcessId branch : self.actions[id].branches)
      during = endedBranch(during, process, branch);
    return during;
  }
  Cases any;
  for (ProcessId branch : self.actions[id].branches) {
    const Cases ended = endedBranch(during, process, branch);
    for (const State& state : ended.all()) any.add(state, mostCases);
  }
  return any;
}

/// A branch that can end stops the others.
void Solver::stopRivals(ProcessId process, NodeId id) {
  if (!(*model[process].graph)[id].isRace()) return;
  const std::vector<ProcessId>& branches = model[process].actions[id].branches;
  for (ProcessId first : branches)
    for (ProcessId other : branches)
      if (other != first && reachable(first, model[first].graph->end)) mark(stopped, other);
}

void Solver::fork(ProcessId process, NodeId id, NodeId next) {
  const Process& self = model[process];
  const std::vector<State> all = cases(process, id);
  for (const State& before : all) {
    for (ProcessId branch : self.actions[id].branches)
      enter(branch, project(before, self, model[branch]));
    stopRivals(process, id);
    const Cases after = joined(before, process, id);
    for (const State& state : after.all()) arrive(process, next, state);
  }
}

bool Solver::mayStop(ProcessId process) const { return interrupted[process] || stopped[process]; }

/// Whether the skill cannot be stopped while it runs. Its pending call can.
bool Solver::isUnstoppable(ProcessId process) const {
  const Process& self = model[process];
  return self.kind == ProcessKind::Skill && model.skill(self).unstoppable;
}

/// Whatever may end a node from outside also stops its callees.
void Solver::stopCallees(ProcessId process, NodeId id, bool stops) {
  if (!stops) return;
  const Action& action = model[process].actions[id];
  bool calls = (*model[process].graph)[id].kind == NodeKind::Call && action.target != kNoProcess;
  if (calls) mark(stopped, action.target);
  for (ProcessId branch : action.branches) mark(stopped, branch);
}

/// A skill that was called but has not started returns `interrupted`, without effects.
void Solver::stopBeforeStart(ProcessId process) {
  const Process& self = model[process];
  if (self.kind != ProcessKind::Skill) return;
  State state = before(process, 0);
  set(state, process, VariableKind::Status, static_cast<unsigned>(Status::Interrupted));
  set(state, process, VariableKind::Called, 0);
  if (interrupted[process]) {
    arrive(process, self.graph->end, std::move(state));
  } else if (stoppedEnds[process].add(std::move(state), mostCases)) {
    announceEnd(process);
  }
}

} // namespace proskill::analysis::flow
