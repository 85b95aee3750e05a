#include "analysis/flow/engine/locks.h"

#include "analysis/program/stop.h"

#include <algorithm>
#include <map>
#include <set>

namespace proskill::analysis::flow {

namespace {

/// A step that sets the variable.
struct Write {
  ValueSet from; ///< values that the conditions of the step allow
  ValueSet to;
};

/// All uses of one variable.
struct Usage {
  std::map<std::pair<ProcessId, NodeId>, Write> writes;
  std::set<ProcessId> writers;
};

State unknownState(const System& system, const Process& process) {
  State state{.reachable = true, .values = {}};
  for (VariableId variable : process.slots.variables())
    state.values.push_back(system.variables()[variable].domain.all());
  return state;
}

/// Tests whether a variable is used as a lock.
class Lock {
public:
  Lock(const System& system, const Usage& usage) : system(system), usage(usage) {
    for (const auto& [place, write] : usage.writes)
      if ((write.from & write.to).empty()) free |= write.from, taken |= write.to;
    isLock = !free.empty() && (free & taken).empty();
    for (ProcessId id : usage.writers)
      if (isLock) follow(id);
    if (isLock) inherit();
  }

  /// Skills that hold the lock whenever they run.
  [[nodiscard]] IdSet holders() const {
    IdSet found;
    if (!isLock) return found;
    for (ProcessId id : inherits) found.insert(id);
    for (ProcessId id : usage.writers)
      if (system[id].kind == ProcessKind::Skill && takesAtStart(id)) found.insert(id);
    return found;
  }

  /// Skills that are called only while the caller holds the lock.
  [[nodiscard]] const std::set<ProcessId>& called() const { return inherits; }

private:
  [[nodiscard]] const Write* write(ProcessId id, NodeId node) const {
    auto found = usage.writes.find({id, node});
    return found == usage.writes.end() ? nullptr : &found->second;
  }

  /// Calls `visit(node, write)` for the writes of a process.
  template <class Visit> void eachWrite(ProcessId id, Visit&& visit) const {
    for (auto it = usage.writes.lower_bound({id, 0});
         it != usage.writes.end() && it->first.first == id; ++it)
      visit(it->first.second, it->second);
  }

  /// The writes of a process, by node.
  [[nodiscard]] std::vector<const Write*> writesOf(ProcessId id, std::size_t nodes) const {
    std::vector<const Write*> result(nodes, nullptr);
    eachWrite(id, [&](NodeId node, const Write& write) { result[node] = &write; });
    return result;
  }

  [[nodiscard]] static bool takes(const Write& write) { return (write.from & write.to).empty(); }
  [[nodiscard]] bool frees(const Write& write) const {
    return !takes(write) && !(write.to & free).empty();
  }

  /// Computes where the thread certainly holds the lock; it is not a lock if another thread frees
  /// it.
  void follow(ProcessId id) {
    const Process& process = system[id];
    if (!process.graph) {
      eachWrite(id, [this](NodeId, const Write& made) { isLock &= !frees(made) && !takes(made); });
      return;
    }
    std::vector<bool> held(process.graph->nodes.size(), true);
    const std::vector<const Write*> made = writesOf(id, held.size());
    held[0] = false;
    for (bool changed = true; changed;) {
      changed = false;
      for (NodeId node = 0; node < held.size(); ++node)
        for (const Edge& edge : (*process.graph)[node].edges) {
          if (edge.target == kNoNode) continue;
          const Write* set = edge.sets ? made[node] : nullptr;
          bool after = set && takes(*set) ? true : held[node] && !(set && frees(*set));
          if (after || !held[edge.target]) continue;
          held[edge.target] = false;
          changed = true;
        }
    }
    for (NodeId node = 0; node < held.size(); ++node)
      if (made[node]) isLock &= held[node] || !frees(*made[node]);
    holds[id] = std::move(held);
  }

  [[nodiscard]] bool holdsAt(const Site& site) const {
    auto own = holds.find(site.caller);
    return inherits.contains(site.caller) || (own != holds.end() && own->second[site.node]);
  }

  [[nodiscard]] bool isCalledByHolders(ProcessId id) const {
    return !system[id].root && std::ranges::all_of(system.callers(id), [this](const Site& site) {
      return !system[site.caller].analysed || holdsAt(site);
    });
  }

  /// Callees of a holder run under the lock.
  void inherit() {
    std::vector<ProcessId> pending(usage.writers.begin(), usage.writers.end());
    while (!pending.empty()) {
      const Process& holder = system[pending.back()];
      pending.pop_back();
      for (NodeId node = 0; holder.graph && node < holder.actions.size(); ++node) {
        ProcessId callee = holder.actions[node].target;
        bool calls = (*holder.graph)[node].kind == NodeKind::Call && callee != kNoProcess;
        if (!calls || inherits.contains(callee) || !isCalledByHolders(callee)) continue;
        inherits.insert(callee);
        pending.push_back(callee);
      }
    }
  }

  [[nodiscard]] bool takesAtStart(ProcessId id) const {
    const Write* start = write(id, 0);
    if (!start || !takes(*start)) return false;
    const std::vector<bool>& held = holds.at(id);
    for (NodeId node = 1; node < held.size(); ++node) {
      NodeKind kind = (*system[id].graph)[node].kind;
      if (kind != NodeKind::End && kind != NodeKind::Refused && !held[node]) return false;
    }
    return true;
  }

  const System& system;
  const Usage& usage;
  ValueSet free;  ///< F
  ValueSet taken; ///< C
  bool isLock = false;
  std::map<ProcessId, std::vector<bool>> holds; ///< by process that writes it, and node
  std::set<ProcessId> inherits;                 ///< all callers hold it
};

void collect(const System& system, ProcessId id, std::map<VariableId, Usage>& usages) {
  const Process& process = system[id];
  const auto matters = [&](const Assignment& each) {
    return each.source && !system.variables()[each.variable].domain.isNumeric();
  };
  const State unknown = unknownState(system, process);
  for (NodeId node = 0; node < process.actions.size(); ++node) {
    const Action& action = process.actions[node];
    if (std::ranges::none_of(action.assignments, matters)) continue;
    State before = unknown;
    bool guarded = process.graph && (*process.graph)[node].kind != NodeKind::InvariantFailure;
    if (guarded) refineAll(before, action.conditions, true);
    if (!before.reachable) continue;
    for (const Assignment& each : action.assignments) {
      if (!matters(each)) continue;
      const Domain& domain = system.variables()[each.variable].domain;
      Write made{each.slot ? before.values[*each.slot] : domain.all(), {}};
      for (const Move& move : moves(each, domain, before)) made.to |= move.to;
      usages[each.variable].writes[{id, node}] = made;
      usages[each.variable].writers.insert(id);
    }
  }
}

} // namespace

std::vector<IdSet> exclusiveSkills(const System& system) {
  std::map<VariableId, Usage> usages;
  for (ProcessId id = 0; id < system.size(); ++id)
    if (system[id].analysed) collect(system, id, usages);
  std::vector<IdSet> exclusive(system.size());
  IdSet called;
  for (const auto& [variable, usage] : usages) {
    stopIfAsked();
    const Lock lock(system, usage);
    IdSet holders = lock.holders();
    for (ProcessId id : lock.called()) called.insert(id);
    forEach(holders, [&](std::size_t id) { exclusive[id].insertAll(holders); });
  }
  for (ProcessId id = 0; id < system.size(); ++id)
    if (!called.contains(id)) exclusive[id].erase(id);
  return exclusive;
}

} // namespace proskill::analysis::flow
