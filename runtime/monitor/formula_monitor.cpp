#include "runtime/monitor/formula_monitor.h"

#include "graph/components.h"
#include "verify/model/nodes.h"

#include <algorithm>

namespace proskill::runtime {

using verify::Moment;
using verify::NodeOp;
using verify::Word;

namespace {

/// The values that a condition can have.
struct Possible {
  bool isTrue = true;
  bool isFalse = true;
};

Possible possible(const verify::System& system, verify::NodeId id, const Word* state) {
  const auto& node = system.nodes[id];
  if (!watchesSteps(system, id)) {
    const bool is = holdsAt(system, id, {state, nullptr, nullptr});
    return {is, !is};
  }
  if (node.op == NodeOp::Not) {
    const auto of = possible(system, node.a, state);
    return {of.isFalse, of.isTrue};
  }
  if (node.op != NodeOp::And && node.op != NodeOp::Or) return {};
  const auto a = possible(system, node.a, state);
  const auto b = possible(system, node.b, state);
  if (node.op == NodeOp::And) return {a.isTrue && b.isTrue, a.isFalse || b.isFalse};
  return {a.isTrue || b.isTrue, a.isFalse && b.isFalse};
}

} // namespace

bool canHold(const verify::System& system, verify::NodeId condition, const Word* state) {
  return possible(system, condition, state).isTrue;
}

FormulaMonitor::FormulaMonitor(const verify::System& of, const verify::Monitor& with)
    : system(of),
      automaton(with),
      live(with.locations.size()),
      current(with.locations.size()),
      next(with.locations.size()) {
  findLive();
}

/// A location is live if an accepting location on a cycle can be reached from it.
void FormulaMonitor::findLive() {
  const auto& all = automaton.locations;
  const auto component = graph::componentsOf(all.size(), [&](std::size_t at, std::size_t i) {
    return i < all[at].edges.size() ? all[at].edges[i].to : graph::kNoNode;
  });
  for (std::uint32_t i = 0; i < all.size(); ++i)
    live[i] = all[i].accepting && std::ranges::any_of(all[i].edges, [&](const auto& edge) {
                return component[edge.to] == component[i];
              });
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t i = 0; i < all.size(); ++i)
      if (!live[i] && std::ranges::any_of(all[i].edges, [&](const auto& e) { return live[e.to]; }))
        changed = live[i] = true;
  }
}

void FormulaMonitor::start(const Word* state) {
  for (const auto location : automaton.initial) current[location] = true;
  arrive(state);
}

void FormulaMonitor::step(const Moment& moment) {
  if (dead) return;
  std::fill(next.begin(), next.end(), false);
  for (std::uint32_t i = 0; i < current.size(); ++i)
    if (current[i])
      for (const auto& edge : automaton.locations[i].edges)
        if (live[edge.to] && holdsAt(system, edge.condition, moment)) next[edge.to] = true;
  std::swap(current, next);
  arrive(moment.after);
}

/// Lets the automaton read the state any number of times.
void FormulaMonitor::arrive(const Word* state) {
  const Moment still{state, nullptr, nullptr};
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t i = 0; i < current.size(); ++i)
      if (current[i])
        for (const auto& edge : automaton.locations[i].edges)
          if (!current[edge.to] && live[edge.to] && holdsAt(system, edge.condition, still))
            changed = current[edge.to] = true;
  }
  dead = !canGoOn(state);
}

bool FormulaMonitor::canGoOn(const Word* state) const {
  for (std::uint32_t i = 0; i < current.size(); ++i)
    if (current[i])
      for (const auto& edge : automaton.locations[i].edges)
        if (live[edge.to] && canHold(system, edge.condition, state)) return true;
  return false;
}

} // namespace proskill::runtime
