#include "analysis/flow/engine/solver.h"

#include "analysis/program/stop.h"

#include <algorithm>
#include <utility>

namespace proskill::analysis::flow {

namespace {

constexpr std::size_t kMostCases = 32;           ///< at a point
constexpr std::size_t kMostCasesInAll = 200'000; ///< limit for large programs

/// Whether calling changes it, even if the skill does not start.
bool isOfCall(VariableKind kind) {
  return kind == VariableKind::Status || kind == VariableKind::Result ||
         kind == VariableKind::Called;
}

} // namespace

Solver::Solver(const System& system) : model(system), moves(system.variables()) {
  prepare();
  prepareEvents();
  startRoots();
  while (!queue.empty()) run(queue.take());
  summarise();
}

// --- Preparation

/// While a skill runs, the skills that it excludes can only be refused.
Solver::Closing Solver::closingOf(ProcessId process, bool inside) {
  IdSet beside = model.concurrent(process);
  if (inside) beside.eraseAll(model.exclusive(process));
  const Slots& slots = model[process].slots;
  Closing closing;
  for (Slot slot = 0; slot < slots.size(); ++slot) {
    VariableKind kind = model.variables()[slots[slot]].kind;
    const bool stale = !inside && model.mayReadStale(process, slots[slot]);
    const IdSet& movers = stale            ? model.everybody()
                          : isOfCall(kind) ? model.concurrent(process)
                                           : beside;
    View& view = moves.of(movers, slots[slot]);
    view.readers.push_back({.process = process, .inside = inside, .slot = slot});
    closing.relations.push_back(&view.relation);
    if (stale) closing.stale.push_back(slot);
  }
  return closing;
}

void Solver::prepare() {
  std::size_t count = model.size();
  std::size_t nodes = 0;
  for (const Process& process : model.all()) nodes += process.actions.size();
  mostCases =
      std::clamp<std::size_t>(kMostCasesInAll / std::max<std::size_t>(nodes, 1), 1, kMostCases);
  states.resize(count);
  rely.resize(count);
  relyInside.resize(count);
  whileCalling.resize(count);
  pending.resize(count);
  grown.resize(count);
  stoppedEnds.resize(count);
  interrupted.resize(count);
  stopped.resize(count);
  for (VariableId id = 0; id < model.variables().size(); ++id)
    byAnyone.push_back(&moves.of(model.everybody(), id).relation);
  for (ProcessId id = 0; id < count; ++id)
    if (model[id].graph && model[id].analysed) prepare(id);
}

void Solver::prepare(ProcessId id) {
  const Process& process = model[id];
  std::size_t nodes = process.graph->nodes.size();
  states[id].resize(nodes);
  whileCalling[id].resize(nodes);
  rely[id] = closingOf(id, false);
  relyInside[id] = closingOf(id, true);
  for (NodeId node = 0; node < nodes; ++node) prepareCall(id, node);
  if (process.kind == ProcessKind::Skill && model.hasFreeInterrupts() &&
      model.skill(process).interrupt)
    interrupted[id] = true;
}

void Solver::prepareCall(ProcessId id, NodeId node) {
  const Process& process = model[id];
  const Action& action = process.actions[node];
  std::vector<ProcessId> callees = action.branches;
  if ((*process.graph)[node].kind == NodeKind::Call && action.target != kNoProcess)
    callees.push_back(action.target);
  IdSet written;
  IdSet inside = model.concurrent(id);
  inside.eraseAll(model.exclusive(id));
  for (ProcessId callee : callees) {
    written.insertAll(model.writes(callee));
    inside.insertAll(model.activity(callee));
  }
  if (callees.empty()) return;
  IdSet refusable = inside;
  refusable.insertAll(model.concurrent(id));
  for (Slot slot = 0; slot < process.slots.size(); ++slot) {
    if (!written.contains(process.slots[slot])) continue;
    VariableKind kind = model.variables()[process.slots[slot]].kind;
    View& view = moves.of(isOfCall(kind) ? refusable : inside, process.slots[slot]);
    view.readers.push_back({.process = id, .node = node, .slot = slot});
    whileCalling[id][node].emplace_back(slot, &view.relation);
  }
  for (ProcessId callee : callees)
    for (VariableId variable : model[callee].slots.variables())
      if (!process.slots.find(variable))
        moves.of(model.everybody(), variable).readers.push_back({.process = id, .node = node});
}

void Solver::startRoots() {
  for (ProcessId id = 0; id < model.size(); ++id) {
    const Process& process = model[id];
    if (!process.graph || !process.root) continue;
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
  for (NodeId event = 0; event < model[id].actions.size(); ++event) {
    State before = anything;
    refineAll(before, model[id].actions[event].conditions, true);
    if (before.reachable) record(before, id, event);
  }
}

// --- Steps

void Solver::close(State& state, const Closing& closing) {
  if (!state.reachable) return;
  for (Slot slot : closing.stale) state.values[slot] |= ValueSet::of(0);
  for (Slot slot : closing.moving)
    state.values[slot] = closing.relations[slot]->closure(state.values[slot]);
}

/// Whether others may interleave before the node. A basic skill's action and its end are one step.
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

void Solver::wake(ProcessId process, NodeId node) {
  if (reachable(process, node)) pending[process].insert(node), schedule(process);
}

/// Handles a move that a reader has not seen yet.
void Solver::grow(const Reader& reader) {
  if (reader.node != kNoNode) return wake(reader.process, reader.node);
  std::vector<Slot>& moving = (reader.inside ? relyInside : rely)[reader.process].moving;
  if (std::ranges::find(moving, reader.slot) == moving.end()) moving.push_back(reader.slot);
  grown[reader.process].insert(reader.slot);
  schedule(reader.process);
}

/// Checks the slots that have grown.
bool Solver::isClosed(ProcessId process, NodeId node) const {
  const Closing& closing = relyAt(process, node);
  return std::ranges::all_of(cases(process, node), [&](const State& state) {
    return std::ranges::all_of(grown[process], [&](Slot slot) {
      return closing.relations[slot]->closure(state.values[slot]) == state.values[slot];
    });
  });
}

void Solver::closeAgain(ProcessId process) {
  const Graph& graph = *model[process].graph;
  for (NodeId node = 0; node < graph.nodes.size(); ++node) {
    if (!reachable(process, node)) continue;
    if (graph[node].kind == NodeKind::Call)
      wake(process, node); // others may have changed the
                           // state meanwhile
    if (!isPoint(process, node) || isClosed(process, node)) continue;
    Cases closed;
    for (State state : cases(process, node)) {
      close(state, relyAt(process, node));
      closed.add(std::move(state), mostCases);
    }
    states[process][node] = std::move(closed);
    wake(process, node);
    if (node == graph.end) announceEnd(process);
  }
  grown[process].clear();
}

void Solver::run(ProcessId process) {
  if (!grown[process].empty()) closeAgain(process);
  std::set<NodeId>& todo = pending[process];
  while (!todo.empty()) {
    NodeId node = *todo.begin();
    todo.erase(todo.begin());
    analysis::stopIfAsked();
    step(process, node);
  }
}

void Solver::step(ProcessId process, NodeId id) {
  const Node& node = (*model[process].graph)[id];
  const Action& action = model[process].actions[id];
  if (node.kind == NodeKind::Interrupt && action.target != kNoProcess) interrupt(process, id);
  if (node.kind == NodeKind::Start && mayStop(process)) stopBeforeStart(process);
  bool stops = mayStop(process) && !isUnstoppable(process);
  for (const Edge& edge : node.edges) {
    if (edge.stops) {
      stops |= stop(process, id, edge);
    } else if (node.kind == NodeKind::Call && action.target != kNoProcess) {
      call(process, id, edge.target);
    } else if (node.kind == NodeKind::Fork) {
      fork(process, id, edge.target);
    } else {
      flow(process, id, edge);
    }
  }
  if (node.waits()) stopCallees(process, id, stops);
}

void Solver::flow(ProcessId process, NodeId id, const Edge& edge) {
  const Process& self = model[process];
  // a skill that was stopped returns to a caller that does not continue
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
    else if (stoppedEnds[process].add(std::move(state), mostCases))
      announceEnd(process);
  }
}

bool Solver::stop(ProcessId process, NodeId id, const Edge& edge) {
  const Process& self = model[process];
  const Action& exit = self.actions[edge.target];
  NodeKind kind = (*self.graph)[edge.target].kind;
  bool fails = kind == NodeKind::InvariantFailure;
  if (kind == NodeKind::Interrupted && !mayStop(process)) return false;
  if (kind == NodeKind::Outcome && !reachable(exit.leaver, exit.leave)) return false;
  bool calls = (*self.graph)[id].kind == NodeKind::Call && self.actions[id].target != kNoProcess;
  bool possible = false;
  const std::vector<State> all = cases(process, id);
  for (const State& before : all) {
    State state = during(before, process, id);
    if (fails) refineAll(state, exit.conditions, false);
    possible |= state.reachable;
    // the branches continue until they have returned
    if (!calls && state.reachable) arrive(process, edge.target, during(state, process, id));
  }
  if (calls && possible) stopCall(process, id, edge.target);
  return possible;
}

/// Sets a variable for the skill itself.
void Solver::set(State& state, ProcessId process, VariableKind kind, unsigned to) {
  const Process& self = model[process];
  VariableId variable = model.variables().of(kind, self.definition);
  record(state, process, model.resolver().constant(variable, to, self.slots));
  if (auto slot = self.slots.find(variable)) state.values[*slot] = ValueSet::of(to);
}

void Solver::mark(std::vector<bool>& flags, ProcessId process) {
  if (flags[process]) return;
  flags[process] = true;
  for (NodeId node = 0; node < states[process].size(); ++node) wake(process, node);
}

void Solver::interrupt(ProcessId process, NodeId id) {
  ProcessId target = model[process].actions[id].target;
  if (!model.skill(model[target]).interrupt) return;
  VariableId isCalled = model.variables().of(VariableKind::Called, model[target].definition);
  auto slot = model[process].slots.find(isCalled);
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

// --- Results of steps

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
  const Domain& domain = model.variables()[assignment.variable].domain;
  for (const Move& move : flow::moves(assignment, domain, before))
    moves.add(process, assignment.variable, move.from, move.to,
              [this](const Reader& reader) { grow(reader); });
}

void Solver::record(const State& before, ProcessId process, NodeId id) {
  for (const Assignment& assignment : model[process].actions[id].assignments)
    record(before, process, assignment);
}

void Solver::arrive(ProcessId process, NodeId node, State state) {
  if (!state.reachable || node == kNoNode) return;
  const Process& self = model[process];
  if (isPoint(process, node)) close(state, relyAt(process, node));
  if (!states[process][node].add(std::move(state), mostCases)) return;
  wake(process, node);
  if ((*self.graph)[node].kind == NodeKind::Leave && self.parent != kNoProcess)
    wakeForks(model.ofSkill(self.definition));
  if (node == self.graph->end) announceEnd(process);
}

/// One of the branches may end the skill.
void Solver::wakeForks(ProcessId skill) {
  const Graph& graph = *model[skill].graph;
  for (NodeId node = 0; node < graph.nodes.size(); ++node)
    if (graph[node].kind == NodeKind::Fork) wake(skill, node);
}

void Solver::announceEnd(ProcessId process) {
  const Process& self = model[process];
  for (const Site& site : model.callers(process))
    if (model[site.caller].analysed) wake(site.caller, site.node);
  if (self.parent != kNoProcess) wake(self.parent, self.graph->fork);
  if (!self.repeats) return;
  const std::vector<State> ends = cases(process, self.graph->end);
  for (const State& end : ends) enter(process, end);
  const std::vector<State> stops = stoppedEnds[process].all();
  for (const State& end : stops) enter(process, end);
}

void Solver::summarise() {
  for (VariableId id = 0; id < model.variables().size(); ++id) everything.push_back(anything(id));
}

} // namespace proskill::analysis::flow
