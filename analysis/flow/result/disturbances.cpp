#include "analysis/flow/result/disturbances.h"

#include <algorithm>

namespace proskill::analysis::flow {

namespace {

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

} // namespace

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

} // namespace proskill::analysis::flow
