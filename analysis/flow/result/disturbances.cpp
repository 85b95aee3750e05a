#include "analysis/flow/result/disturbances.h"

#include <algorithm>

namespace proskill::analysis::flow {

Disturbances::Disturbances(const System& of) : system(of), guards(of.size()) {
  for (ProcessId process = 0; process < system.size(); ++process)
    if (system[process].graph) collect(process);
}

void Disturbances::collect(ProcessId id) {
  const Process& process = system[id];
  const auto& nodes = process.graph->nodes;
  bool leaves = false;
  for (NodeId node = 0; node < nodes.size(); ++node) {
    const NodeKind kind = nodes[node].kind;
    leaves = leaves || kind == NodeKind::Leave;
    if (kind == NodeKind::InvariantFailure) guards[id].push_back(node);
    if (kind == NodeKind::Interrupt && process.actions[node].target != kNoProcess)
      interrupts.push_back({id, process.actions[node].target});
  }
  if (!guards[id].empty()) guarded.push_back(id);
  if (process.kind != ProcessKind::Branch) return;
  if (leaves) leaving.push_back(id);
  if ((*system[process.parent].graph)[process.graph->fork].isRace()) branches.push_back(id);
}

/// A thread with those that forked it or called its skill, transitively.
IdSet Disturbances::threadsAround(ProcessId thread) const {
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

/// Whether the branch of a race may win against one of these threads.
bool Disturbances::racesWith(ProcessId branch, const IdSet& threads) const {
  const Process& process = system[branch];
  const auto& all = system[process.parent].actions[process.graph->fork].branches;
  return std::ranges::any_of(all, [&](ProcessId each) { return threads.contains(each); });
}

bool Disturbances::mayBeEnded(ProcessId thread) const {
  const IdSet around = threadsAround(thread);
  const auto isBeside = [&](ProcessId branch) {
    return !around.contains(branch) && around.contains(system[branch].parent);
  };
  return std::ranges::any_of(guarded,
                             [&](ProcessId id) { return id != thread && around.contains(id); }) ||
         std::ranges::any_of(leaving, isBeside) ||
         std::ranges::any_of(branches,
                             [&](ProcessId id) { return isBeside(id) && racesWith(id, around); }) ||
         std::ranges::any_of(interrupts, [&](const Interrupt& each) {
           return each.by != thread && around.contains(each.of);
         });
}

bool Disturbances::mayBeHeldUp(ProcessId caller, ProcessId callee) const {
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

} // namespace proskill::analysis::flow
