#include "verify/refine/step_cycles.h"

#include "graph/components.h"
#include "verify/reduce/live_variables.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

StepCycles::StepCycles(const System& of, const Reductions& with, const ZoneGraph& explored,
                       const Bits& repeating, LimitWatch& watch)
    : system(of),
      reductions(with),
      graph(explored),
      limits(watch),
      arcs(explored.states.size()),
      state(of.words) {
  for (StateId from = 0; from < arcs.size(); ++from) addArcs(from, repeating);
  component = graph::componentsOf(arcs.size(), [&](graph::Node node, std::size_t i) {
    return i < arcs[node].size() ? arcs[node][i].to : graph::kNoNode;
  });
  sortInstances();
}

/// A step without a clock is possible whenever the discrete state allows it, so the graph has all
/// states that it leads to.
void StepCycles::addArcs(StateId from, const Bits& repeating) {
  graph.states.read(from, state.data());
  graph.enabling.compute(state.data(), enabled);
  eachIn(enabled, [&](TransitionId step) {
    limits.check();
    if (!repeating.contains(step)) return;
    next = state;
    log.clear();
    if (fire(system, step, next.data(), log) != Outcome::Done) {
      isLacking = true;
      return;
    }
    if (reductions.liveVariables) reductions.liveVariables->clean(next.data());
    const auto root = graph.states.findRoot(next.data(), path);
    const StateId to = root ? graph.states.find(*root) : kNone;
    isLacking = isLacking || to == kNone;
    if (to != kNone) arcs[from].push_back({to, step});
  });
}

void StepCycles::sortInstances() {
  for (StateId from = 0; from < arcs.size(); ++from)
    for (const auto& arc : arcs[from])
      if (isOnCycle(from, arc))
        for (auto part : system.transitions[arc.step].parts)
          onCycles.insert(system.paths[part].instance);
}

bool StepCycles::moves(const Arc& arc, InstanceId instance) const {
  return std::ranges::any_of(system.transitions[arc.step].parts,
                             [&](PathId part) { return system.paths[part].instance == instance; });
}

StepCycles::Cycle StepCycles::cycleOf(InstanceId instance) const {
  for (StateId from = 0; from < arcs.size(); ++from)
    for (const auto& arc : arcs[from]) {
      if (!isOnCycle(from, arc) || !moves(arc, instance)) continue;
      Cycle cycle{from, {arc.step}};
      append(cycle.steps, way(arc.to, from));
      return cycle;
    }
  std::unreachable();
}

/// A shortest way between two states of a component.
Steps StepCycles::way(StateId from, StateId to) const {
  struct Seen {
    StateId state = 0;
    std::size_t before = 0;
    TransitionId step = kNone;
  };
  std::vector<Seen> seen{{from}};
  Bits known;
  known.insert(from);
  std::size_t at = 0;
  for (; seen[at].state != to; ++at)
    for (const auto& arc : arcs[seen[at].state]) {
      if (known.contains(arc.to) || component[arc.to] != component[to]) continue;
      known.insert(arc.to);
      seen.push_back({arc.to, at, arc.step});
    }
  Steps steps;
  for (; seen[at].step != kNone; at = seen[at].before) steps.push_back(seen[at].step);
  std::ranges::reverse(steps);
  return steps;
}

} // namespace proskill::verify
