#include "analysis/flow/system.h"

#include "analysis/flow/compile.h"
#include "analysis/flow/locks.h"

#include <algorithm>
#include <unordered_map>

namespace proskill::analysis::flow {

System::System(const Program& program) : source(program), shared(program), names(program, shared) {
  addProcesses();
  link();
  chooseRoots();
  findActivities();
  findConcurrency();
  chooseSlots();
  compile();
  excluded = exclusiveSkills(*this);
}

Location System::at(const Process& process, syntax::Range range) const {
  switch (process.kind) {
  case ProcessKind::Environment: return source.environments.all[process.definition].at(range);
  case ProcessKind::Skill:
  case ProcessKind::Branch:
  case ProcessKind::Events: break;
  }
  return source.skills.all[process.definition].at(range);
}

void System::addThreads(const SkillGraph& graph, ProcessKind kind, std::size_t definition) {
  auto first = static_cast<ProcessId>(processes.size());
  for (const Graph& each : graph.graphs) {
    bool branch = &each != graph.graphs.data();
    processes.push_back({.kind = branch ? ProcessKind::Branch : kind,
                         .definition = definition,
                         .graph = &each,
                         .parent = branch ? first + each.parent : kNoProcess});
    processes.back().actions.resize(each.nodes.size());
  }
}

void System::addProcesses() {
  for (std::size_t i = 0; i < source.skills.all.size(); ++i) {
    skillProcess.push_back(static_cast<ProcessId>(processes.size()));
    addThreads(graphs.emplace_back(buildGraph(*source.skills.all[i].node)), ProcessKind::Skill, i);
  }
  for (std::size_t i = 0; i < source.environments.all.size(); ++i)
    addThreads(graphs.emplace_back(buildGraph(*source.environments.all[i].node)),
               ProcessKind::Environment, i);
  eventProcess = static_cast<ProcessId>(processes.size());
  processes.push_back({.kind = ProcessKind::Events, .root = hasFreeEvents()});
  processes.back().actions.resize(source.events.all.size());
}

void System::link() {
  sites.resize(processes.size());
  for (ProcessId id = 0; id < eventProcess; ++id)
    for (NodeId node = 0; node < processes[id].graph->nodes.size(); ++node) linkNode(id, node);
}

void System::linkNode(ProcessId id, NodeId nodeId) {
  Process& process = processes[id];
  const Node& node = (*process.graph)[nodeId];
  Action& action = process.actions[nodeId];
  if (node.kind == NodeKind::Call || node.kind == NodeKind::Interrupt) {
    std::string_view word =
        node.kind == NodeKind::Call ? node.statement->head.text : node.statement->name.text;
    if (auto skill = names.skill(word)) action.target = skillProcess[*skill];
    if (node.kind == NodeKind::Call && action.target != kNoProcess)
      sites[action.target].push_back({id, nodeId});
  }
  // Branches stand behind the thread that forks them, in the order of the graphs.
  if (node.kind == NodeKind::Fork) {
    ProcessId first = id;
    while (processes[first].kind == ProcessKind::Branch) --first;
    for (GraphId branch : node.branches) action.branches.push_back(first + branch);
  }
}

void System::chooseRoots() {
  for (const auto* each : mainSkill(source).candidates)
    candidates.push_back(skillProcess[static_cast<std::size_t>(each - source.skills.all.data())]);
  for (ProcessId id : candidates) processes[id].root = true;
  for (std::size_t i = 0; i < source.skills.all.size(); ++i) {
    Process& process = processes[skillProcess[i]];
    const syntax::Skill& skill = *source.skills.all[i].node;
    bool free = candidates.empty() && !skill.isComposite();
    process.root |= free || (skill.monitor && skill.isComposite());
    process.repeats = free;
  }
  for (Process& process : processes) process.root |= process.kind == ProcessKind::Environment;
}

std::vector<ProcessId> System::startedBy(const Process& process) const {
  std::vector<ProcessId> started;
  if (!process.graph) return started;
  for (NodeId node = 0; node < process.graph->nodes.size(); ++node) {
    const Action& action = process.actions[node];
    if ((*process.graph)[node].kind == NodeKind::Call && action.target != kNoProcess)
      started.push_back(action.target);
    started.insert(started.end(), action.branches.begin(), action.branches.end());
  }
  return started;
}

namespace {

/// Adds to each process what it starts has, until nothing is new. \pre `started` per process
void closeOver(std::vector<Bits>& sets, const std::vector<std::vector<ProcessId>>& started) {
  for (bool grew = true; grew;) {
    grew = false;
    for (std::size_t id = sets.size(); id-- > 0;)
      for (ProcessId next : started[id]) grew |= next != id && sets[id].insertAll(sets[next]);
  }
}

} // namespace

void System::findActivities() {
  std::vector<std::vector<ProcessId>> started;
  for (ProcessId id = 0; id < processes.size(); ++id) {
    started.push_back(startedBy(processes[id]));
    activities.emplace_back(processes.size()).insert(id);
  }
  closeOver(activities, started);
  for (const Process& root : processes)
    if (root.root)
      forEach(activities[&root - processes.data()],
              [this](std::size_t id) { processes[id].analysed = true; });
}

void System::findConcurrency() {
  others.assign(processes.size(), Bits(processes.size()));
  auto beside = [this](ProcessId a, ProcessId b) {
    forEach(activities[a], [&](std::size_t id) { others[id].insertAll(activities[b]); });
  };
  std::vector<ProcessId> roots;
  for (ProcessId id = 0; id < eventProcess; ++id)
    if (processes[id].root) roots.push_back(id);
  auto alternatives = [this](ProcessId a, ProcessId b) {
    return std::ranges::count(candidates, a) > 0 && std::ranges::count(candidates, b) > 0;
  };
  for (ProcessId a : roots)
    for (ProcessId b : roots)
      if (a != b && !alternatives(a, b)) beside(a, b);
  for (const Process& process : processes)
    for (const Action& action : process.actions)
      for (ProcessId a : action.branches)
        for (ProcessId b : action.branches)
          if (a != b) beside(a, b);
  for (ProcessId id = 0; id < processes.size(); ++id) {
    if (hasFreeEvents()) others[id].insert(eventProcess);
    others[id].erase(id);
  }
}

void System::chooseSlots() {
  std::vector<Bits> reads;
  std::vector<std::vector<ProcessId>> started;
  Bits readAnywhere(shared.size());
  for (ProcessId id = 0; id < processes.size(); ++id) {
    reads.push_back(readsOf(id));
    readAnywhere.insertAll(reads.back());
    started.push_back(startedBy(processes[id]));
  }
  for (ProcessId id = 0; id < processes.size(); ++id)
    for (VariableId variable : writesOf(*this, processes[id]))
      if (readAnywhere.contains(variable)) reads[id].insert(variable);
  closeOver(reads, started);
  for (ProcessId id = 0; id < processes.size(); ++id) {
    std::vector<VariableId> variables;
    forEach(reads[id], [&](std::size_t v) { variables.push_back(static_cast<VariableId>(v)); });
    processes[id].slots = Slots(std::move(variables));
  }
}

Bits System::readsOf(ProcessId id) const {
  const Process& process = processes[id];
  std::vector<VariableId> reads;
  if (process.graph)
    addReads(*this, process, reads);
  else
    for (const auto& event : source.events.all) addReads(event->effects, names, shared, reads);
  Bits set(shared.size());
  for (VariableId variable : reads) set.insert(variable);
  return set;
}

void System::compile() {
  for (Process& process : processes) compileActions(*this, process);
  std::unordered_map<const syntax::Statement*, std::pair<ProcessId, NodeId>> leaves;
  for (ProcessId id = 0; id < eventProcess; ++id)
    for (NodeId node = 0; node < processes[id].graph->nodes.size(); ++node)
      if ((*processes[id].graph)[node].kind == NodeKind::Leave)
        leaves[(*processes[id].graph)[node].statement] = {id, node};
  for (ProcessId id = 0; id < eventProcess; ++id)
    for (NodeId node = 0; node < processes[id].graph->nodes.size(); ++node) {
      const Node& each = (*processes[id].graph)[node];
      auto found = leaves.find(each.statement);
      if (each.kind != NodeKind::Outcome || !each.statement || found == leaves.end()) continue;
      processes[id].actions[node].leaver = found->second.first;
      processes[id].actions[node].leave = found->second.second;
    }
}

} // namespace proskill::analysis::flow
