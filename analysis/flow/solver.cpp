#include "analysis/flow/solver.h"

#include <utility>

namespace proskill::analysis::flow {

Solver::Solver(const System& system) : model(system), moves(system.variables(), system.size()) {
  prepare();
  prepareEvents();
  while (!queue.empty()) {
    ProcessId next = *queue.begin();
    queue.erase(queue.begin());
    run(next);
  }
  summarise();
}

// Preparation -------------------------------------------------------------------------------------

Solver::Closing Solver::closingOf(ProcessId process, const Bits& processes) {
  Closing closing;
  for (VariableId variable : model[process].slots.variables())
    closing.push_back(&moves.of(processes, variable));
  return closing;
}

/// While a skill runs, those that it excludes can only be refused.
Solver::Closing Solver::closingInside(ProcessId process) {
  Bits beside = model.concurrent(process);
  beside.eraseAll(model.exclusive(process));
  Closing closing;
  for (VariableId variable : model[process].slots.variables()) {
    VariableKind kind = model.variables()[variable].kind;
    bool refusable = kind == VariableKind::Status || kind == VariableKind::Result;
    closing.push_back(&moves.of(refusable ? model.concurrent(process) : beside, variable));
  }
  return closing;
}

void Solver::prepare() {
  std::size_t count = model.size();
  states.resize(count);
  rely.resize(count);
  relyInside.resize(count);
  whileCalling.resize(count);
  pending.resize(count);
  interrupted.resize(count);
  stopped.resize(count);
  readers.resize(model.variables().size());
  for (ProcessId id = 0; id < count; ++id) {
    const Process& process = model[id];
    if (!process.graph || !process.analysed) continue;
    std::size_t nodes = process.graph->nodes.size();
    states[id].resize(nodes);
    pending[id].resize(nodes);
    whileCalling[id].resize(nodes);
    rely[id] = closingOf(id, model.concurrent(id));
    relyInside[id] = closingInside(id);
    for (VariableId variable : process.slots.variables()) readers[variable].push_back(id);
    for (NodeId node = 0; node < nodes; ++node) {
      const Action& action = process.actions[node];
      bool calls = (*process.graph)[node].kind == NodeKind::Call && action.target != kNoProcess;
      if (!calls && action.branches.empty()) continue;
      Bits inside = model.concurrent(id);
      if (calls) inside.insertAll(model.activity(action.target));
      for (ProcessId branch : action.branches) inside.insertAll(model.activity(branch));
      whileCalling[id][node] = closingOf(id, inside);
    }
  }
  for (ProcessId id = 0; id < count; ++id) {
    const Process& process = model[id];
    if (!process.graph || !process.analysed) continue;
    if (process.kind == ProcessKind::Skill && model.hasFreeEvents() &&
        model.skill(process).interrupt)
      interrupted[id] = true;
    if (!process.root) continue;
    State start{.reachable = true, .values = {}};
    for (VariableId variable : process.slots.variables())
      start.values.push_back(model.variables()[variable].initial);
    enter(id, start);
  }
}

void Solver::prepareEvents() {
  if (!model.hasFreeEvents()) return;
  for (std::size_t event = 0; event < model.program().events.all.size(); ++event) {
    ProcessId id = model.ofEvent(event);
    State anything{.reachable = true, .values = {}};
    for (VariableId variable : model[id].slots.variables())
      anything.values.push_back(model.variables()[variable].domain.all());
    record(anything, id, 0);
  }
}

// Steps -------------------------------------------------------------------------------------------

void Solver::close(State& state, const Closing& closing) const {
  if (!state.reachable) return;
  for (std::size_t slot = 0; slot < state.values.size(); ++slot)
    state.values[slot] = closing[slot]->closure(state.values[slot]);
}

/// Others may come in before it. A basic skill's action and its end are one step.
bool Solver::isPoint(ProcessId process, NodeId node) const {
  const Process& self = model[process];
  NodeKind kind = (*self.graph)[node].kind;
  bool ends = kind == NodeKind::Outcome || kind == NodeKind::InvariantFailure ||
              kind == NodeKind::Interrupted;
  return !(*self.graph)[node].atomic && (!ends || model.skill(self).isComposite());
}

const Solver::Closing& Solver::relyAt(ProcessId process, NodeId node) const {
  NodeKind kind = (*model[process].graph)[node].kind;
  bool inside = kind != NodeKind::Start && kind != NodeKind::Refused && kind != NodeKind::End;
  return (inside ? relyInside : rely)[process];
}

void Solver::run(ProcessId process) {
  running = process;
  std::vector<bool>& todo = pending[process];
  State exit = states[process][model[process].graph->end];
  for (NodeId node = 0; node < todo.size(); ++node) {
    if (isPoint(process, node)) close(states[process][node], relyAt(process, node));
    todo[node] = states[process][node].reachable;
  }
  if (exit.join(states[process][model[process].graph->end])) announceEnd(process);
  for (cursor = 0; cursor < todo.size();) {
    NodeId node = cursor++;
    if (!todo[node]) continue;
    todo[node] = false;
    step(process, node);
  }
  running = kNoProcess;
}

void Solver::step(ProcessId process, NodeId id) {
  const Node& node = (*model[process].graph)[id];
  const Action& action = model[process].actions[id];
  if (node.kind == NodeKind::Interrupt && action.target != kNoProcess) interrupt(process, id);
  if (node.waits()) stopCallees(process, id);
  if (node.kind == NodeKind::Start && stopped[process]) stopBeforeStart(process);
  State inside;
  for (const Edge& edge : node.edges) {
    if (edge.stops) {
      if (!inside.reachable) inside = during(process, id);
      stop(process, id, edge, inside);
    } else if (node.kind == NodeKind::Call && action.target != kNoProcess) {
      call(process, id, edge.target);
    } else if (node.kind == NodeKind::Fork) {
      fork(process, id, edge.target);
    } else {
      flow(process, id, edge);
    }
  }
}

void Solver::flow(ProcessId process, NodeId id, const Edge& edge) {
  const Process& self = model[process];
  NodeKind kind = (*self.graph)[id].kind;
  State state = states[process][id];
  if (edge.guard != Guard::None)
    refineAll(state, self.actions[id].conditions, edge.guard == Guard::Holds);
  if (!state.reachable) return;
  if (edge.sets) {
    record(state, process, id);
    state = after(std::move(state), self, id);
  }
  // One that its caller has stopped returns to nobody who goes on.
  if (kind == NodeKind::Interrupted && !interrupted[process]) {
    if (self.repeats) enter(process, state);
    return;
  }
  arrive(process, edge.target, std::move(state));
}

void Solver::stop(ProcessId process, NodeId id, const Edge& edge, const State& inside) {
  const Process& self = model[process];
  const Action& exit = self.actions[edge.target];
  NodeKind kind = (*self.graph)[edge.target].kind;
  State state = inside;
  if (kind == NodeKind::InvariantFailure) refineAll(state, exit.conditions, false);
  if (kind == NodeKind::Interrupted && !mayStop(process)) return;
  if (kind == NodeKind::Outcome && !reachable(exit.leaver, exit.leave)) return;
  if (!state.reachable) return;
  // What it has called goes on until it has returned.
  const Closing& closing = whileCalling[process][id];
  if (!closing.empty()) close(state, closing);
  arrive(process, edge.target, std::move(state));
}

bool Solver::mayStop(ProcessId process) const { return interrupted[process] || stopped[process]; }

/// Whatever may end a node from outside stops what the node has called.
void Solver::stopCallees(ProcessId process, NodeId id) {
  const Process& self = model[process];
  const Node& node = (*self.graph)[id];
  const Action& action = self.actions[id];
  bool stops = mayStop(process);
  for (const Edge& edge : node.edges)
    if (edge.stops && (*self.graph)[edge.target].kind != NodeKind::Interrupted)
      stops |= reachable(process, edge.target);
  if (!stops) return;
  if (node.kind == NodeKind::Call && action.target != kNoProcess) mark(stopped, action.target);
  for (ProcessId branch : action.branches) mark(stopped, branch);
}

/// A skill that was called but waits for its resources returns with `interrupted`, without effects.
void Solver::stopBeforeStart(ProcessId process) {
  const Process& self = model[process];
  if (self.kind != ProcessKind::Skill) return;
  auto set = [&](VariableKind kind, std::int64_t to) {
    VariableId variable = model.variables().of(kind, self.definition);
    record(states[process][0], process, model.resolver().constant(variable, to, self.slots));
  };
  set(VariableKind::Status, static_cast<std::int64_t>(Status::Interrupted));
  set(VariableKind::Result, 0);
}

void Solver::mark(std::vector<bool>& flags, ProcessId process) {
  if (flags[process]) return;
  flags[process] = true;
  schedule(process);
}

void Solver::interrupt(ProcessId process, NodeId id) {
  ProcessId target = model[process].actions[id].target;
  if (!model.skill(model[target]).interrupt) return;
  VariableId isRunning = model.variables().of(VariableKind::Running, model[target].definition);
  auto slot = model[process].slots.find(isRunning);
  if (!slot || states[process][id].values[*slot].contains(1)) mark(interrupted, target);
}

// Calls -------------------------------------------------------------------------------------------

State Solver::project(const State& state, const Process& from, const Process& to) const {
  State result{.reachable = state.reachable, .values = {}};
  if (!state.reachable) return result;
  for (VariableId variable : to.slots.variables())
    result.values.push_back(state.values[*from.slots.find(variable)]);
  return result;
}

State Solver::during(ProcessId process, NodeId node) const {
  State state = states[process][node];
  const Closing& closing = whileCalling[process][node];
  if (!closing.empty()) close(state, closing);
  return state;
}

State Solver::atCallee(ProcessId caller, NodeId call) const {
  return project(states[caller][call], model[caller], model[model[caller].actions[call].target]);
}

void Solver::enter(ProcessId process, const State& state) { arrive(process, 0, state); }

/// After a call that was served: what holds both for all returns of the callee and for whatever may
/// have happened since this call.
State Solver::returned(ProcessId process, NodeId id) const {
  const Process& self = model[process];
  ProcessId target = self.actions[id].target;
  const Process& callee = model[target];
  State entry = atCallee(process, id);
  refineAll(entry, callee.actions[0].conditions, true);
  const State& exit = states[target][callee.graph->end];
  if (!entry.reachable || !exit.reachable) return {};
  State state = during(process, id);
  for (Slot slot = 0; slot < callee.slots.size(); ++slot) {
    Slot mine = *self.slots.find(callee.slots[slot]);
    ValueSet left = rely[process][mine]->closure(exit.values[slot]);
    state.values[mine] &= left;
    if (state.values[mine].empty()) return {};
  }
  return state;
}

State Solver::refused(ProcessId process, NodeId id) const {
  const Process& self = model[process];
  const Process& callee = model[self.actions[id].target];
  if (callee.actions[0].conditions.empty()) return {};
  State entry = atCallee(process, id);
  refineAll(entry, callee.actions[0].conditions, false);
  if (!entry.reachable) return {};
  State state = states[process][id];
  for (Slot slot = 0; slot < callee.slots.size(); ++slot)
    state.values[*self.slots.find(callee.slots[slot])] = entry.values[slot];
  for (VariableKind kind : {VariableKind::Status, VariableKind::Result})
    if (auto slot = self.slots.find(model.variables().of(kind, callee.definition)))
      state.values[*slot] = ValueSet::of(0);
  return state;
}

void Solver::call(ProcessId process, NodeId id, NodeId next) {
  ProcessId target = model[process].actions[id].target;
  enter(target, atCallee(process, id));
  arrive(process, next, returned(process, id));
  arrive(process, next, refused(process, id));
}

void Solver::fork(ProcessId process, NodeId id, NodeId next) {
  const Process& self = model[process];
  const Action& action = self.actions[id];
  State joined = during(process, id);
  for (ProcessId branch : action.branches) {
    const Process& thread = model[branch];
    enter(branch, project(states[process][id], self, thread));
    const State& end = states[branch][thread.graph->end];
    if (!end.reachable) joined.reachable = false;
    for (Slot slot = 0; joined.reachable && slot < thread.slots.size(); ++slot) {
      ValueSet& mine = joined.values[*self.slots.find(thread.slots[slot])];
      mine &= end.values[slot];
      joined.reachable = !mine.empty();
    }
  }
  arrive(process, next, std::move(joined));
}

// Results of steps --------------------------------------------------------------------------------

State Solver::after(State state, const Process& process, NodeId id) const {
  return assigned(std::move(state), process, id, false);
}

State Solver::afterEffects(State state, const Process& process, NodeId id) const {
  return assigned(std::move(state), process, id, true);
}

State Solver::assigned(State state, const Process& process, NodeId id, bool effectsOnly) const {
  State before = state;
  for (const Assignment& assignment : process.actions[id].assignments) {
    if (!assignment.slot || (effectsOnly && !assignment.source)) continue;
    ValueSet to;
    const Domain& domain = model.variables()[assignment.variable].domain;
    for (const Move& move : flow::moves(assignment, domain, before)) to |= move.to;
    state.values[*assignment.slot] = to;
  }
  return state;
}

void Solver::record(const State& before, ProcessId process, const Assignment& assignment) {
  bool grew = false;
  const Domain& domain = model.variables()[assignment.variable].domain;
  for (const Move& move : flow::moves(assignment, domain, before))
    grew |= moves.add(process, assignment.variable, move.from, move.to);
  if (grew) scheduleReaders(process, assignment.variable);
}

void Solver::record(const State& before, ProcessId process, NodeId id) {
  for (const Assignment& assignment : model[process].actions[id].assignments)
    record(before, process, assignment);
}

void Solver::scheduleReaders(ProcessId writer, VariableId variable) {
  for (ProcessId reader : readers[variable])
    if (model.concurrent(reader).contains(writer) || model.activity(reader).contains(writer))
      schedule(reader);
}

void Solver::arrive(ProcessId process, NodeId node, State state) {
  if (!state.reachable || node == kNoNode) return;
  if (isPoint(process, node)) close(state, relyAt(process, node));
  if (!states[process][node].join(state)) return;
  if (process == running) {
    pending[process][node] = true;
    cursor = std::min(cursor, node);
  } else {
    schedule(process);
  }
  if ((*model[process].graph)[node].kind == NodeKind::Leave && model[process].parent != kNoProcess)
    schedule(model.ofSkill(model[process].definition));
  if (node == model[process].graph->end) announceEnd(process);
}

void Solver::announceEnd(ProcessId process) {
  const Process& self = model[process];
  for (const Site& site : model.callers(process))
    if (model[site.caller].analysed) schedule(site.caller);
  if (self.parent != kNoProcess) schedule(self.parent);
  if (self.repeats) enter(process, states[process][self.graph->end]);
}

void Solver::summarise() {
  Bits all(model.size());
  for (ProcessId id = 0; id < model.size(); ++id) all.insert(id);
  for (VariableId id = 0; id < model.variables().size(); ++id) {
    byAnyone.push_back(&moves.of(all, id));
    everything.push_back(byAnyone.back()->closure(model.variables()[id].initial));
  }
}

} // namespace proskill::analysis::flow
