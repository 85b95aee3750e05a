#include "analysis/flow/result/instant_rounds.h"

#include "analysis/flow/result/loops.h"
#include "analysis/flow/result/report.h"

#include <algorithm>
#include <utility>

namespace proskill::analysis::flow {

namespace {

constexpr std::size_t kMostSteps = 5000;  ///< of the search in one loop
constexpr std::size_t kMostRepeats = 100; ///< until the values no longer change from round to round

/// A step without delay: along an edge of a node or, for a call, past a false precondition.
struct Pass {
  NodeId node = kNoNode;
  std::size_t edge = 0;
  std::size_t precondition = 0;
};

bool hasNode(const Process& process, NodeKind kind) {
  return process.graph &&
         std::ranges::find(process.graph->nodes, kind, &Node::kind) != process.graph->nodes.end();
}

/// A thread with those that forked it or called its skill, transitively.
IdSet threadsAround(const System& system, ProcessId thread) {
  IdSet around;
  std::vector<ProcessId> todo{thread};
  while (!todo.empty()) {
    const ProcessId at = todo.back();
    todo.pop_back();
    if (at == kNoProcess || around.contains(at)) continue;
    around.insert(at);
    todo.push_back(system[at].parent);
    if (system[at].kind == ProcessKind::Skill)
      for (const Site& site : system.callers(at)) todo.push_back(site.caller);
  }
  return around;
}

/// Whether it belongs to a race against one of these threads.
bool racesWith(const System& system, const Process& branch, const IdSet& threads) {
  const NodeId fork = branch.graph->fork;
  if (!(*system[branch.parent].graph)[fork].isRace()) return false;
  const auto& branches = system[branch.parent].actions[fork].branches;
  return std::ranges::any_of(branches, [&](ProcessId each) { return threads.contains(each); });
}

/// Whether others may end it at once: by a guard of a caller, by a parallel branch that ends the
/// skill or wins a race, or by an interrupt.
bool mayBeEnded(const System& system, ProcessId thread) {
  const IdSet around = threadsAround(system, thread);
  for (ProcessId other = 0; other < system.size(); ++other) {
    const Process& process = system[other];
    if (other != thread && around.contains(other) && hasNode(process, NodeKind::InvariantFailure))
      return true;
    if (!around.contains(other) && process.kind == ProcessKind::Branch &&
        around.contains(process.parent) &&
        (hasNode(process, NodeKind::Leave) || racesWith(system, process, around)))
      return true;
    if (other == thread || !process.graph) continue;
    for (NodeId node = 0; node < process.actions.size(); ++node)
      if ((*process.graph)[node].kind == NodeKind::Interrupt &&
          process.actions[node].target != kNoProcess &&
          around.contains(process.actions[node].target))
        return true;
  }
  return false;
}

/// How a condition restricts a state: `Certain` requires it to be true in all of the state.
enum class Need : std::uint8_t { Possible, Certain };

bool require(State& state, const Condition& condition, bool holds, Need need) {
  if (need == Need::Certain) return holds ? !mayFail(state, condition) : !mayHold(state, condition);
  refine(state, condition, holds);
  return state.reachable;
}

class Rounds {
public:
  Rounds(const Solver& solver, ProcessId id, const std::vector<NodeId>& loop)
      : solver(solver), system(solver.system()), id(id), self(system[id]), loop(loop) {
    for (const Node& node : self.graph->nodes)
      if (node.kind == NodeKind::InvariantFailure)
        guards.push_back(static_cast<NodeId>(&node - self.graph->nodes.data()));
  }

  std::optional<InstantRound> find() {
    if (mayBeEnded(system, id)) return std::nullopt;
    for (NodeId head : loop)
      for (const State& start : solver.cases(id, head)) {
        path.clear();
        if (search(head, head, start)) return found();
      }
    return std::nullopt;
  }

private:
  [[nodiscard]] const Node& nodeOf(NodeId node) const { return (*self.graph)[node]; }

  bool search(NodeId head, NodeId node, const State& state) {
    if (++steps > kMostSteps) return false;
    for (const Pass& pass : passesOf(node)) {
      State after = state;
      const NodeId next = target(pass);
      if (std::ranges::find(loop, next) == loop.end() || !take(pass, after, Need::Possible))
        continue;
      path.push_back(pass);
      if (next == head ? repeats(std::move(after)) : !isOnPath(next) && search(head, next, after))
        return true;
      path.pop_back();
    }
    return false;
  }

  [[nodiscard]] bool isOnPath(NodeId node) const {
    return std::ranges::find(path, node, &Pass::node) != path.end();
  }

  [[nodiscard]] std::vector<Pass> passesOf(NodeId node) const {
    std::vector<Pass> all;
    const Node& each = nodeOf(node);
    const bool calls = each.kind == NodeKind::Call;
    const std::size_t ways = calls ? calleeOf(node).actions[0].conditions.size() : 1;
    for (std::size_t edge = 0; edge < each.edges.size(); ++edge)
      for (std::size_t i = 0; i < ways && !takesTime(each, each.edges[edge]); ++i)
        all.push_back({node, edge, i});
    return all;
  }

  /// Also true for what another check reports.
  [[nodiscard]] static bool takesTime(const Node& node, const Edge& edge) {
    const bool isTimeout = node.kind == NodeKind::Wait && edge.guard != Guard::Holds;
    return edge.stops || isTimeout;
  }

  [[nodiscard]] NodeId target(const Pass& pass) const {
    return nodeOf(pass.node).edges[pass.edge].target;
  }
  [[nodiscard]] const Process& calleeOf(NodeId node) const {
    return system[self.actions[node].target];
  }

  /// Repeats a round until nothing changes; then every step has to be certain.
  bool repeats(State state) const {
    if (std::ranges::none_of(path, [&](const Pass& pass) { return mayWait(pass.node); }))
      return false; // reported by another check
    if (dependsOnOthers()) return false;
    for (std::size_t i = 0; i < kMostRepeats; ++i) {
      const State before = state;
      if (!goRound(state, Need::Possible)) return false;
      if (state.values != before.values) continue;
      return goRound(state, Need::Certain) && state.values == before.values;
    }
    return false;
  }

  [[nodiscard]] bool mayWait(NodeId node) const {
    const NodeKind kind = nodeOf(node).kind;
    return kind == NodeKind::Wait || kind == NodeKind::Call ||
           (kind == NodeKind::Emit && !takesNoTime(self, node));
  }

  /// Whether it depends on values that others set. Only single events make each combination
  /// certainly possible: parallel skills may keep an order that the solver does not see, as may
  /// events with `:every` or `:guard`.
  [[nodiscard]] bool dependsOnOthers() const {
    const IdSet read = variablesRead();
    for (ProcessId other = 0; other < system.size(); ++other)
      if (system[other].kind != ProcessKind::Events && system.concurrent(id).contains(other) &&
          system.writes(other).intersects(read))
        return true;
    if (!system.hasFreeEvents()) return false;
    const auto& events = system[system.ofEvents()].actions;
    for (std::size_t event = 0; event < events.size(); ++event) {
      const auto sets = std::ranges::count_if(events[event].assignments, [&](const auto& each) {
        return read.contains(each.variable);
      });
      if (sets > 1 || (sets > 0 && !events[event].conditions.empty())) return true;
      if (sets > 0 && isTimed(event) && !isRefused() && !isAwaited()) return true;
    }
    return false;
  }

  [[nodiscard]] bool isTimed(std::size_t event) const {
    return system.program().events.all[event]->every.has_value();
  }

  /// Whether the round contains a refused call; the finding is then about what follows a refusal.
  [[nodiscard]] bool isRefused() const {
    return std::ranges::any_of(
        path, [&](const Pass& pass) { return nodeOf(pass.node).kind == NodeKind::Call; });
  }

  /// Whether the loop tests nothing but one variable in one wait that does not end before an event
  /// has set it. Then the round follows whenever the loop is reached.
  [[nodiscard]] bool isAwaited() const {
    NodeId waiting = kNoNode;
    for (const Pass& pass : path) {
      if (slotsOf(pass.node).empty()) continue;
      if (nodeOf(pass.node).kind != NodeKind::Wait || waiting != kNoNode) return false;
      waiting = pass.node;
    }
    if (waiting == kNoNode || !guards.empty()) return false;
    const bool hasTimeout = std::ranges::any_of(nodeOf(waiting).edges, [](const Edge& edge) {
      return !edge.stops && edge.guard != Guard::Holds;
    });
    const auto slots = slotsOf(waiting);
    return !hasTimeout && slots.size() == 1 && !sets(*slots.begin()) &&
           isMadeByEvent(*slots.begin(), self.actions[waiting].conditions.at(0));
  }

  [[nodiscard]] std::set<Slot> slotsOf(NodeId node) const {
    std::set<Slot> slots;
    for (const Condition& each : self.actions[node].conditions) collectSlots(each, slots);
    return slots;
  }

  /// Whether the round itself sets it.
  [[nodiscard]] bool sets(Slot slot) const {
    return std::ranges::any_of(path, [&](const Pass& pass) {
      const auto& assignments = self.actions[pass.node].assignments;
      return nodeOf(pass.node).kind == NodeKind::Call ||
             std::ranges::find(assignments, slot, &Assignment::slot) != assignments.end();
    });
  }

  [[nodiscard]] bool isMadeByEvent(Slot slot, const Condition& condition) const {
    const VariableId variable = self.slots[slot];
    for (const Action& event : system[system.ofEvents()].actions)
      for (const Assignment& each : event.assignments) {
        if (each.variable != variable || each.value.kind != Term::Kind::Number) continue;
        State state = solver.cases(id, path.front().node).front();
        const std::int64_t number = each.value.number;
        state.values[slot] = system.variables()[variable].domain.saturated({number, number});
        if (!mayFail(state, condition)) return true;
      }
    return false;
  }

  [[nodiscard]] IdSet variablesRead() const {
    IdSet read;
    const auto add = [&](const Process& process, const Condition& condition) {
      std::set<Slot> slots;
      collectSlots(condition, slots);
      for (Slot slot : slots) read.insert(process.slots[slot]);
    };
    for (const Pass& pass : path) {
      for (const Condition& each : self.actions[pass.node].conditions) add(self, each);
      if (nodeOf(pass.node).kind == NodeKind::Call)
        add(calleeOf(pass.node), calleeOf(pass.node).actions[0].conditions[pass.precondition]);
    }
    for (NodeId guard : guards) add(self, self.actions[guard].conditions.at(0));
    return read;
  }

  bool goRound(State& state, Need need) const {
    return std::ranges::all_of(path, [&](const Pass& pass) { return take(pass, state, need); });
  }

  /// \return whether the pass is possible, or certain
  bool take(const Pass& pass, State& state, Need need) const {
    for (NodeId guard : guards)
      if (!require(state, self.actions[guard].conditions.at(0), true, need)) return false;
    const Edge& edge = nodeOf(pass.node).edges[pass.edge];
    if (nodeOf(pass.node).kind == NodeKind::Call) return refuse(pass, state, need);
    if (nodeOf(pass.node).kind == NodeKind::Interrupt && disturbs(pass.node)) return false;
    if (edge.guard != Guard::None)
      for (const Condition& condition : self.actions[pass.node].conditions)
        if (!require(state, condition, edge.guard == Guard::Holds, need)) return false;
    if (edge.sets) state = solver.after(std::move(state), self, pass.node);
    return state.reachable;
  }

  /// Whether what is interrupted may set something that the loop reads.
  [[nodiscard]] bool disturbs(NodeId node) const {
    const ProcessId interrupted = self.actions[node].target;
    if (interrupted == kNoProcess) return false;
    return std::ranges::any_of(self.slots.variables(), [&](VariableId variable) {
      return system.variables()[variable].kind != VariableKind::Called &&
             system.writes(interrupted).contains(variable);
    });
  }

  /// The call resets it before the preconditions are tested.
  [[nodiscard]] bool isReset(const Process& callee, VariableId variable) const {
    return variable == system.variables().of(VariableKind::Status, callee.definition) ||
           variable == system.variables().of(VariableKind::Result, callee.definition);
  }

  bool refuse(const Pass& pass, State& state, Need need) const {
    const Process& callee = calleeOf(pass.node);
    State entry{.reachable = true, .values = {}};
    for (VariableId variable : callee.slots.variables()) {
      const auto mine = self.slots.find(variable);
      if (isReset(callee, variable))
        entry.values.push_back(ValueSet::of(0));
      else
        entry.values.push_back(mine ? state.values[*mine] : solver.ever(variable));
    }
    if (!require(entry, callee.actions[0].conditions[pass.precondition], false, need)) return false;
    for (Slot slot = 0; slot < callee.slots.size(); ++slot)
      if (const auto mine = self.slots.find(callee.slots[slot]))
        state.values[*mine] = entry.values[slot];
    for (VariableKind kind : {VariableKind::Status, VariableKind::Result, VariableKind::Called})
      if (const auto slot = self.slots.find(system.variables().of(kind, callee.definition)))
        state.values[*slot] = ValueSet::of(0);
    return true;
  }

  [[nodiscard]] InstantRound found() const {
    InstantRound round;
    for (const Pass& pass : path) {
      round.nodes.push_back(pass.node);
      const NodeKind kind = nodeOf(pass.node).kind;
      if (kind == NodeKind::Call && !round.refusal) round.refusal = {pass.node, pass.precondition};
      if (kind == NodeKind::Wait && round.wait == kNoNode) round.wait = pass.node;
    }
    std::ranges::sort(round.nodes);
    return round;
  }

  const Solver& solver;
  const System& system;
  ProcessId id;
  const Process& self;
  const std::vector<NodeId>& loop;
  std::vector<NodeId> guards;
  std::vector<Pass> path;
  std::size_t steps = 0;
};

/// Whether others may delay the call: they call the same skill, or hold what it needs.
bool mayBeHeldUp(const System& system, ProcessId caller, ProcessId callee) {
  const auto& needed = system.skill(system[callee]).resources;
  const auto holds = [&](ProcessId other) {
    const Process& process = system[other];
    if (other == callee || process.kind != ProcessKind::Skill) return false;
    return std::ranges::any_of(system.skill(process).resources, [&](const syntax::Name& held) {
      return std::ranges::find(needed, held.text, &syntax::Name::text) != needed.end();
    });
  };
  const auto& beside = system.concurrent(caller);
  if (std::ranges::any_of(system.callers(callee),
                          [&](const Site& site) { return beside.contains(site.caller); }))
    return true;
  if (needed.empty()) return false;
  for (ProcessId other = 0; other < system.size(); ++other)
    if (holds(other) && (beside.contains(other) || system.activity(other).contains(caller)))
      return true;
  return false;
}

} // namespace

bool mayTakeNoTime(const Solver& solver, ProcessId process, NodeId node) {
  const Node& each = (*solver.system()[process].graph)[node];
  const ProcessId target = solver.system()[process].actions[node].target;
  if (each.kind == NodeKind::Call)
    return target != kNoProcess && !mayBeHeldUp(solver.system(), process, target);
  return each.kind == NodeKind::Wait || each.kind == NodeKind::Emit ||
         takesNoTime(solver.system()[process], node);
}

std::optional<InstantRound> instantRound(const Solver& solver, ProcessId process,
                                         const std::vector<NodeId>& loop) {
  return Rounds(solver, process, loop).find();
}

} // namespace proskill::analysis::flow
