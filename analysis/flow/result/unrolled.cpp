#include "analysis/flow/result/unrolled.h"

#include "analysis/flow/result/report.h"

#include <map>
#include <set>
#include <utility>

namespace proskill::analysis::flow {

namespace {

constexpr std::size_t kMostNodes = 10'000;

/// The class of each counter's value, in the order of their slots.
using Counts = std::vector<unsigned>;

class Unroller {
public:
  Unroller(const Solver& solver, ProcessId id, std::vector<Slot> counters)
      : solver(solver),
        system(solver.system()),
        id(id),
        process(system[id]),
        counters(std::move(counters)) {}

  /// \return false if the result would be too large
  bool run() {
    for (const Counts& counts : choices(solver.before(id, 0))) place(0, counts);
    for (std::size_t next = 0; next < result.original.size(); ++next) {
      if (result.original.size() > kMostNodes) return false;
      for (const Edge& edge : (*process.graph)[result.original[next]].edges)
        follow(static_cast<NodeId>(next), edge);
    }
    result.graph.end = kNoNode;
    for (NodeId node = 0; node < result.original.size(); ++node)
      if (result.original[node] == process.graph->end) result.graph.end = node;
    return true;
  }

  Unrolled result;

private:
  /// All combinations of single values of the counters.
  [[nodiscard]] std::vector<Counts> choices(const State& state) const {
    std::vector<Counts> all{{}};
    for (Slot slot : counters) {
      std::vector<Counts> longer;
      for (const Counts& known : all)
        forEach(state.values[slot], [&](unsigned value) {
          longer.push_back(known);
          longer.back().push_back(value);
        });
      all = std::move(longer);
    }
    return all;
  }

  NodeId place(NodeId node, const Counts& counts) {
    // the end is a single place, whatever the counters are
    const bool ends = node == process.graph->end;
    auto [entry, isNew] =
        known.try_emplace({node, ends ? Counts() : counts}, result.original.size());
    if (isNew) {
      Node copy = (*process.graph)[node];
      copy.edges.clear();
      result.graph.nodes.push_back(std::move(copy));
      result.original.push_back(node);
      countsOf.push_back(counts);
    }
    return static_cast<NodeId>(entry->second);
  }

  void follow(NodeId from, const Edge& edge) {
    NodeId node = result.original[from];
    if (edge.target == kNoNode || !solver.reachable(id, edge.target)) return;
    State after;
    for (const State& before : solver.cases(id, node)) after.join(taken(before, from, edge));
    if (!after.reachable) return;
    for (const Counts& counts : choices(after)) {
      Edge copy = edge;
      copy.target = place(edge.target, counts);
      result.graph.nodes[from].edges.push_back(copy);
    }
  }

  /// The state after an edge that is taken with the counters of the place.
  [[nodiscard]] State taken(State state, NodeId from, const Edge& edge) const {
    NodeId node = result.original[from];
    for (std::size_t i = 0; i < counters.size(); ++i) {
      state.values[counters[i]] &= ValueSet::of(countsOf[from][i]);
      if (state.values[counters[i]].empty()) return {};
    }
    if (edge.guard != Guard::None)
      refineAll(state, process.actions[node].conditions, edge.guard == Guard::Holds);
    if (state.reachable && edge.sets) state = solver.after(std::move(state), process, node);
    return state;
  }

  const Solver& solver;
  const System& system;
  ProcessId id;
  const Process& process;
  std::vector<Slot> counters;
  std::map<std::pair<NodeId, Counts>, std::size_t> known;
  std::vector<Counts> countsOf; ///< by node of the result
};

/// Whether others may set it while the process runs: parallel processes, or callees.
bool isSetByOthers(const Solver& solver, ProcessId id, VariableId variable) {
  const System& system = solver.system();
  IdSet others = system.concurrent(id);
  others.insertAll(system.activity(id));
  others.erase(id);
  bool isSet = false;
  forEach(others, [&](std::size_t other) {
    if (!system[static_cast<ProcessId>(other)].analysed) return;
    for (const Action& action : system[static_cast<ProcessId>(other)].actions)
      for (const Assignment& each : action.assignments) isSet |= each.variable == variable;
  });
  return isSet;
}

std::vector<Slot> countersOf(const Solver& solver, ProcessId id) {
  const System& system = solver.system();
  const Process& process = system[id];
  std::set<Slot> tested;
  std::set<VariableId> set;
  for (NodeId node = 0; node < process.actions.size(); ++node) {
    if ((*process.graph)[node].kind == NodeKind::Test)
      for (const Condition& each : process.actions[node].conditions) collectSlots(each, tested);
    for (const Assignment& each : process.actions[node].assignments) set.insert(each.variable);
  }
  std::vector<Slot> counters;
  for (Slot slot : tested) {
    VariableId variable = process.slots[slot];
    if (system.variables()[variable].kind != VariableKind::StateVariable) continue;
    if (system.variables()[variable].domain.isNumeric() && set.contains(variable) &&
        !isSetByOthers(solver, id, variable))
      counters.push_back(slot);
  }
  return counters;
}

} // namespace

Unrolled unrolled(const Solver& solver, ProcessId process) {
  Unroller counted(solver, process, countersOf(solver, process));
  if (counted.run()) return std::move(counted.result);
  Unroller plain(solver, process, {});
  plain.run();
  return std::move(plain.result);
}

} // namespace proskill::analysis::flow
