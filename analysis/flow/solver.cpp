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
  stoppedEnds.resize(count);
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
  ProcessId id = model.ofEvents();
  State anything{.reachable = true, .values = {}};
  for (VariableId variable : model[id].slots.variables())
    anything.values.push_back(model.variables()[variable].domain.all());
  for (NodeId event = 0; event < model[id].actions.size(); ++event) record(anything, id, event);
}

// Steps -------------------------------------------------------------------------------------------

void Solver::close(State& state, const Closing& closing) {
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

/// After somebody's interference has grown.
void Solver::closeAgain(ProcessId process, NodeId node) {
  if (!isPoint(process, node)) return;
  Cases closed;
  bool changed = false;
  for (const State& known : states[process][node].all()) {
    State state = known;
    close(state, relyAt(process, node));
    changed |= state.values != known.values;
    closed.add(std::move(state));
  }
  if (!changed) return;
  states[process][node] = std::move(closed);
  if (node == model[process].graph->end) announceEnd(process);
}

void Solver::run(ProcessId process) {
  running = process;
  std::vector<bool>& todo = pending[process];
  for (NodeId node = 0; node < todo.size(); ++node) {
    closeAgain(process, node);
    todo[node] = reachable(process, node);
  }
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
  if (node.kind == NodeKind::Start && stopped[process]) stopBeforeStart(process);
  for (const Edge& edge : node.edges) {
    if (edge.stops) {
      stop(process, id, edge);
    } else if (node.kind == NodeKind::Call && action.target != kNoProcess) {
      call(process, id, edge.target);
    } else if (node.kind == NodeKind::Fork) {
      fork(process, id, edge.target);
    } else {
      flow(process, id, edge);
    }
  }
  if (node.waits()) stopCallees(process, id);
}

void Solver::flow(ProcessId process, NodeId id, const Edge& edge) {
  const Process& self = model[process];
  // One that its caller has stopped returns to nobody who goes on.
  bool returns = (*self.graph)[id].kind != NodeKind::Interrupted || interrupted[process];
  const std::vector<State> all = cases(process, id);
  for (State state : all) {
    if (edge.guard != Guard::None)
      refineAll(state, self.actions[id].conditions, edge.guard == Guard::Holds);
    if (!state.reachable) continue;
    if (edge.sets) {
      record(state, process, id);
      state = after(std::move(state), self, id);
    }
    if (edge.target == kNoNode) {
      if (self.repeats) enter(process, state);
    } else if (returns)
      arrive(process, edge.target, std::move(state));
    else if (stoppedEnds[process].add(std::move(state)))
      announceEnd(process);
  }
}

void Solver::stop(ProcessId process, NodeId id, const Edge& edge) {
  const Process& self = model[process];
  const Action& exit = self.actions[edge.target];
  NodeKind kind = (*self.graph)[edge.target].kind;
  bool fails = kind == NodeKind::InvariantFailure;
  if (kind == NodeKind::Interrupted && !mayStop(process)) return;
  if (kind == NodeKind::Outcome && !reachable(exit.leaver, exit.leave)) return;
  State inside = during(process, id);
  if (fails) refineAll(inside, exit.conditions, false);
  if (!inside.reachable) return;
  bool calls = (*self.graph)[id].kind == NodeKind::Call && self.actions[id].target != kNoProcess;
  if (calls) return stopCall(process, id, edge.target);
  const std::vector<State> all = cases(process, id);
  for (const State& before : all) {
    State state = during(before, process, id);
    if (fails) refineAll(state, exit.conditions, false);
    // The branches go on until they have returned.
    arrive(process, edge.target, during(state, process, id));
  }
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
  State state = before(process, 0);
  auto set = [&](VariableKind kind, unsigned to) {
    VariableId variable = model.variables().of(kind, self.definition);
    record(state, process, model.resolver().constant(variable, to, self.slots));
    if (auto slot = self.slots.find(variable)) state.values[*slot] = ValueSet::of(to);
  };
  set(VariableKind::Status, static_cast<unsigned>(Status::Interrupted));
  set(VariableKind::Result, 0);
  if (self.repeats) enter(process, state);
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
  if (!slot || before(process, id).values[*slot].contains(1)) mark(interrupted, target);
}

bool Solver::mayHold(ProcessId process, NodeId node, const Condition& condition) const {
  return std::ranges::any_of(cases(process, node),
                             [&](const State& state) { return flow::mayHold(state, condition); });
}

bool Solver::mayFail(ProcessId process, NodeId node, const Condition& condition) const {
  return std::ranges::any_of(cases(process, node),
                             [&](const State& state) { return flow::mayFail(state, condition); });
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
  if (!states[process][node].add(std::move(state))) return;
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
  if (!self.repeats) return;
  const std::vector<State> ends = cases(process, self.graph->end);
  for (const State& end : ends) enter(process, end);
  const std::vector<State> stops = stoppedEnds[process].all();
  for (const State& end : stops) enter(process, end);
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
