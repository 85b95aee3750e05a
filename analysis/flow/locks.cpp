#include "analysis/flow/locks.h"

#include <map>

namespace proskill::analysis::flow {

namespace {

/// Of one variable: who may use it as a lock, and how.
struct Lock {
  std::vector<ProcessId> holders;
  ValueSet free;    ///< F
  ValueSet taken;   ///< C
  ValueSet written; ///< by anyone but the holders
};

State unknownState(const System& system, const Process& process) {
  State state{.reachable = true, .values = {}};
  for (VariableId variable : process.slots.variables())
    state.values.push_back(system.variables()[variable].domain.all());
  return state;
}

class Finder {
public:
  explicit Finder(const System& system) : system(system) {}

  std::vector<Bits> find() {
    for (ProcessId id = 0; id < system.size(); ++id)
      if (system[id].analysed) visit(id);
    std::vector<Bits> exclusive(system.size(), Bits(system.size()));
    for (const auto& [variable, lock] : locks)
      if (excludes(lock)) exclude(lock.holders, exclusive);
    return exclusive;
  }

private:
  static bool excludes(const Lock& lock) {
    return lock.holders.size() > 1 && (lock.free & (lock.taken | lock.written)).empty();
  }

  static void exclude(const std::vector<ProcessId>& holders, std::vector<Bits>& exclusive) {
    for (ProcessId a : holders)
      for (ProcessId b : holders)
        if (a != b) exclusive[a].insert(b);
  }

  void visit(ProcessId id) {
    const Process& process = system[id];
    State unknown = unknownState(system, process);
    std::map<VariableId, ValueSet> starts;
    if (process.kind == ProcessKind::Skill) starts = started(id, unknown);
    for (NodeId node = 0; node < process.actions.size(); ++node) {
      NodeKind kind = process.graph ? (*process.graph)[node].kind : NodeKind::Step;
      bool ends = kind == NodeKind::Outcome || kind == NodeKind::InvariantFailure ||
                  kind == NodeKind::Interrupted;
      for (const Assignment& each : process.actions[node].assignments) {
        bool holds = starts.contains(each.variable);
        if (each.source && !(holds && (ends || kind == NodeKind::Start)))
          locks[each.variable].written |= target(each, unknown);
      }
    }
  }

  /// Makes the process a holder of each variable that its start takes; these, with what it sets.
  std::map<VariableId, ValueSet> started(ProcessId id, const State& unknown) {
    const Action& start = system[id].actions[0];
    State entry = unknown;
    refineAll(entry, start.conditions, true);
    std::map<VariableId, ValueSet> taken;
    for (const Assignment& each : start.assignments) {
      if (!each.source || !each.slot || !entry.reachable) continue;
      ValueSet set = target(each, entry);
      if (!(entry.values[*each.slot] & set).empty()) continue;
      taken[each.variable] = set;
      Lock& lock = locks[each.variable];
      lock.holders.push_back(id);
      lock.free |= entry.values[*each.slot];
      lock.taken |= set;
    }
    return taken;
  }

  [[nodiscard]] ValueSet target(const Assignment& assignment, const State& before) const {
    ValueSet to;
    const Domain& domain = system.variables()[assignment.variable].domain;
    for (const Move& move : moves(assignment, domain, before)) to |= move.to;
    return to;
  }

  const System& system;
  std::map<VariableId, Lock> locks;
};

} // namespace

std::vector<Bits> exclusiveSkills(const System& system) { return Finder(system).find(); }

} // namespace proskill::analysis::flow
