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
  ProcessId process = kNoProcess;
  NodeId node = kNoNode;
  std::size_t edge = 0;
  std::size_t precondition = 0;
  std::vector<Pass> inner; ///< of a call that is served: the callee's steps, from start to end
};
using Passes = std::vector<Pass>;

/// How a condition restricts a state: `Certain` requires it to be true in all of the state.
enum class Need : std::uint8_t { Possible, Certain };

bool require(State& state, const Condition& condition, bool holds, Need need) {
  if (need == Need::Certain) return holds ? !mayFail(state, condition) : !mayHold(state, condition);
  refine(state, condition, holds);
  return state.reachable;
}

class Rounds {
public:
  Rounds(const Solver& solver, const Disturbances& others, ProcessId id,
         const std::vector<NodeId>& loop)
      : solver(solver),
        others(others),
        system(solver.system()),
        id(id),
        self(system[id]),
        loop(loop) {}

  std::optional<InstantRound> find() {
    if (others.mayBeEnded(id)) return std::nullopt;
    for (NodeId head : loop)
      for (const State& start : solver.cases(id, head)) {
        path.clear();
        if (search(head, head, start)) return found();
      }
    return std::nullopt;
  }

private:
  [[nodiscard]] const Node& nodeOf(const Pass& pass) const {
    return (*system[pass.process].graph)[pass.node];
  }
  [[nodiscard]] const Action& actionOf(const Pass& pass) const {
    return system[pass.process].actions[pass.node];
  }

  bool search(NodeId head, NodeId node, const State& state) {
    if (++steps > kMostSteps) return false;
    for (const Pass& pass : passesOf(id, node, state)) {
      State after = state;
      const NodeId next = target(pass);
      if (std::ranges::find(loop, next) == loop.end() || !take(pass, after, Need::Possible))
        continue;
      path.push_back(pass);
      if (next == head ? repeats(std::move(after)) : !isOn(path, next) && search(head, next, after))
        return true;
      path.pop_back();
    }
    return false;
  }

  [[nodiscard]] static bool isOn(const Passes& way, NodeId node) {
    return std::ranges::find(way, node, &Pass::node) != way.end();
  }

  [[nodiscard]] Passes passesOf(ProcessId process, NodeId node, const State& state) {
    Passes all;
    const Node& each = (*system[process].graph)[node];
    for (std::size_t edge = 0; edge < each.edges.size(); ++edge) {
      if (takesTime(each, each.edges[edge])) continue;
      const Pass pass{process, node, edge, 0, {}};
      if (each.kind == NodeKind::Call)
        addCalls(pass, state, all);
      else
        all.push_back(pass);
    }
    return all;
  }

  void addCalls(const Pass& call, const State& state, Passes& all) {
    for (std::size_t i = 0; i < calleeOf(call).actions[0].conditions.size(); ++i) {
      all.push_back(call);
      all.back().precondition = i;
    }
    const ProcessId callee = actionOf(call).target;
    if (!system.skill(system[callee]).isComposite() || !others.guardsOf(call.process).empty() ||
        others.mayBeHeldUp(call.process, callee) || others.mayBeEnded(callee))
      return;
    Passes way;
    addServed(call, callee, 0, entryOf(call, state), way, all);
  }

  /// Adds the call with each way through the body of the callee that takes no time.
  void addServed(const Pass& call, ProcessId callee, NodeId node, const State& state, Passes& way,
                 Passes& all) {
    if (node == system[callee].graph->end) {
      all.push_back(call);
      all.back().inner = way;
      return;
    }
    if (++steps > kMostSteps || !mayBePassed(callee, node)) return;
    for (const Pass& pass : passesOf(callee, node, state)) {
      State after = state;
      if (target(pass) == kNoNode || isOn(way, target(pass)) || !take(pass, after, Need::Possible))
        continue;
      way.push_back(pass);
      addServed(call, callee, target(pass), after, way, all);
      way.pop_back();
    }
  }

  [[nodiscard]] bool mayBePassed(ProcessId process, NodeId node) const {
    const NodeKind kind = (*system[process].graph)[node].kind;
    return kind == NodeKind::Start || kind == NodeKind::Outcome ||
           mayTakeNoTime(solver, others, process, node);
  }

  /// Also true for what another check reports.
  [[nodiscard]] static bool takesTime(const Node& node, const Edge& edge) {
    const bool isTimeout = node.kind == NodeKind::Wait && edge.guard != Guard::Holds;
    return edge.stops || isTimeout;
  }

  [[nodiscard]] NodeId target(const Pass& pass) const {
    return nodeOf(pass).edges[pass.edge].target;
  }
  [[nodiscard]] const Process& calleeOf(const Pass& call) const {
    return system[actionOf(call).target];
  }

  /// Repeats a round until nothing changes; then every step has to be certain.
  bool repeats(State state) const {
    if (!refusalIn(path) &&
        std::ranges::none_of(path, [&](const Pass& pass) { return mayWait(pass); }))
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

  [[nodiscard]] bool mayWait(const Pass& pass) const {
    const NodeKind kind = nodeOf(pass).kind;
    return kind == NodeKind::Wait || (kind == NodeKind::Emit && !takesNoTime(self, pass.node));
  }

  /// The first refused call.
  [[nodiscard]] std::optional<InstantRound::Refusal> refusalIn(const Passes& way) const {
    for (const Pass& pass : way) {
      if (nodeOf(pass).kind != NodeKind::Call) continue;
      if (pass.inner.empty()) return {{pass.process, pass.node, pass.precondition}};
      if (const auto found = refusalIn(pass.inner)) return found;
    }
    return std::nullopt;
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
      if (sets > 0 && isTimed(event) && !refusalIn(path) && !isAwaited()) return true;
    }
    return false;
  }

  [[nodiscard]] bool isTimed(std::size_t event) const {
    return system.program().events.all[event]->every.has_value();
  }

  /// Whether the loop tests nothing but one variable in one wait that does not end before an event
  /// has set it. Then the round follows whenever the loop is reached.
  [[nodiscard]] bool isAwaited() const {
    NodeId waiting = kNoNode;
    for (const Pass& pass : path) {
      if (!pass.inner.empty()) return false;
      if (slotsOf(pass.node).empty()) continue;
      if (nodeOf(pass).kind != NodeKind::Wait || waiting != kNoNode) return false;
      waiting = pass.node;
    }
    if (waiting == kNoNode || !others.guardsOf(id).empty()) return false;
    const bool hasTimeout = std::ranges::any_of((*self.graph)[waiting].edges, [](const Edge& edge) {
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
      return nodeOf(pass).kind == NodeKind::Call ||
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
    for (NodeId guard : others.guardsOf(id))
      addRead(self, self.actions[guard].conditions.at(0), read);
    addReads(path, read);
    return read;
  }

  static void addRead(const Process& process, const Condition& condition, IdSet& read) {
    std::set<Slot> slots;
    collectSlots(condition, slots);
    for (Slot slot : slots) read.insert(process.slots[slot]);
  }

  void addReads(const Passes& way, IdSet& read) const {
    for (const Pass& pass : way) {
      for (const Condition& each : actionOf(pass).conditions)
        addRead(system[pass.process], each, read);
      if (nodeOf(pass).kind != NodeKind::Call) continue;
      const Process& callee = calleeOf(pass);
      if (pass.inner.empty())
        addRead(callee, callee.actions[0].conditions[pass.precondition], read);
      else
        for (NodeId guard : others.guardsOf(actionOf(pass).target))
          addRead(callee, callee.actions[guard].conditions.at(0), read);
      addReads(pass.inner, read);
    }
  }

  bool goRound(State& state, Need need) const {
    return std::ranges::all_of(path, [&](const Pass& pass) { return take(pass, state, need); });
  }

  /// \return whether the pass is possible, or certain
  bool take(const Pass& pass, State& state, Need need) const {
    const Process& process = system[pass.process];
    if (nodeOf(pass).kind != NodeKind::Start)
      for (NodeId guard : others.guardsOf(pass.process))
        if (!require(state, process.actions[guard].conditions.at(0), true, need)) return false;
    const Edge& edge = nodeOf(pass).edges[pass.edge];
    if (nodeOf(pass).kind == NodeKind::Call)
      return pass.inner.empty() ? refuse(pass, state, need) : serve(pass, state, need);
    if (nodeOf(pass).kind == NodeKind::Interrupt && disturbs(pass)) return false;
    if (edge.guard != Guard::None)
      for (const Condition& condition : actionOf(pass).conditions)
        if (!require(state, condition, edge.guard == Guard::Holds, need)) return false;
    if (edge.sets) state = solver.after(std::move(state), process, pass.node);
    return state.reachable;
  }

  /// Whether what is interrupted may set something that the loop or the thread reads.
  [[nodiscard]] bool disturbs(const Pass& pass) const {
    const ProcessId interrupted = actionOf(pass).target;
    if (interrupted == kNoProcess) return false;
    const auto isSet = [&](VariableId variable) {
      return system.variables()[variable].kind != VariableKind::Called &&
             system.writes(interrupted).contains(variable);
    };
    return std::ranges::any_of(self.slots.variables(), isSet) ||
           std::ranges::any_of(system[pass.process].slots.variables(), isSet);
  }

  /// What the callee knows at its start: the call resets its status and result.
  [[nodiscard]] State entryOf(const Pass& call, const State& state) const {
    const Process& callee = calleeOf(call);
    State entry{.reachable = true, .values = {}};
    for (VariableId variable : callee.slots.variables()) {
      const auto mine = system[call.process].slots.find(variable);
      entry.values.push_back(mine ? state.values[*mine] : solver.ever(variable));
    }
    for (VariableKind kind : {VariableKind::Status, VariableKind::Result})
      if (const auto slot = callee.slots.find(system.variables().of(kind, callee.definition)))
        entry.values[*slot] = ValueSet::of(0);
    return entry;
  }

  /// The caller learns what the callee knows at its end.
  void learn(const Pass& call, const State& end, State& state) const {
    const Slots& slots = system[call.process].slots;
    const Process& callee = calleeOf(call);
    for (Slot slot = 0; slot < slots.size(); ++slot)
      if (const auto known = callee.slots.find(slots[slot]))
        state.values[slot] = end.values[*known];
      else if (system.writes(actionOf(call).target).contains(slots[slot]))
        state.values[slot] = solver.ever(slots[slot]);
  }

  bool refuse(const Pass& pass, State& state, Need need) const {
    const Process& callee = calleeOf(pass);
    State entry = entryOf(pass, state);
    if (!require(entry, callee.actions[0].conditions[pass.precondition], false, need)) return false;
    const Slots& slots = system[pass.process].slots;
    for (Slot slot = 0; slot < callee.slots.size(); ++slot)
      if (const auto mine = slots.find(callee.slots[slot]))
        state.values[*mine] = entry.values[slot];
    for (VariableKind kind : {VariableKind::Status, VariableKind::Result, VariableKind::Called})
      if (const auto slot = slots.find(system.variables().of(kind, callee.definition)))
        state.values[*slot] = ValueSet::of(0);
    return true;
  }

  bool serve(const Pass& pass, State& state, Need need) const {
    State inside = entryOf(pass, state);
    for (const Pass& each : pass.inner)
      if (!take(each, inside, need)) return false;
    learn(pass, inside, state);
    return true;
  }

  [[nodiscard]] InstantRound found() const {
    InstantRound round{.refusal = refusalIn(path)};
    for (const Pass& pass : path) {
      round.nodes.push_back(pass.node);
      if (nodeOf(pass).kind == NodeKind::Wait && round.wait == kNoNode) round.wait = pass.node;
    }
    std::ranges::sort(round.nodes);
    return round;
  }

  const Solver& solver;
  const Disturbances& others;
  const System& system;
  ProcessId id;
  const Process& self;
  const std::vector<NodeId>& loop;
  Passes path;
  std::size_t steps = 0;
};

} // namespace

bool mayTakeNoTime(const Solver& solver, const Disturbances& others, ProcessId process,
                   NodeId node) {
  const Node& each = (*solver.system()[process].graph)[node];
  const ProcessId target = solver.system()[process].actions[node].target;
  if (each.kind == NodeKind::Call)
    return target != kNoProcess && !others.mayBeHeldUp(process, target);
  return each.kind == NodeKind::Wait || each.kind == NodeKind::Emit ||
         takesNoTime(solver.system()[process], node);
}

std::optional<InstantRound> instantRound(const Solver& solver, const Disturbances& others,
                                         ProcessId process, const std::vector<NodeId>& loop) {
  return Rounds(solver, others, process, loop).find();
}

} // namespace proskill::analysis::flow
