#include "analysis/flow/engine/system.h"

#include "analysis/flow/engine/compile.h"
#include "analysis/flow/engine/locks.h"
#include "analysis/program/stop.h"

#include <algorithm>
#include <unordered_map>

namespace proskill::analysis::flow {

namespace {

/// Limits of the number of values in the states of all points of a thread, and of the program. Only
/// very large programs exceed them; then some variables are not tracked.
constexpr std::size_t kMostInThread = 16'000'000;
constexpr std::size_t kMostInherited = 2'000'000;
constexpr std::size_t kEnough = 64; ///< number of variables that are always tracked

/// The variables to track: those that the process reads, within the limits, then those that its
/// callees read. Other variables may have any of their values.
IdSet followed(const IdSet& own, const IdSet& inherited, std::size_t nodes) {
  IdSet all = own;
  all.keepFirst(std::max(kEnough, kMostInThread / std::max<std::size_t>(nodes, 1)));
  all.insertAll(inherited);
  return all;
}

} // namespace

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

bool System::mayReadStale(ProcessId reader, VariableId id) const {
  const Variable& variable = shared[id];
  const Process& process = processes[reader];
  if (variable.kind != VariableKind::Status && variable.kind != VariableKind::Result) return false;
  if (process.kind != ProcessKind::Skill && process.kind != ProcessKind::Branch) return false;
  const ProcessId skill = skillProcess[variable.definition];
  const auto& calls = sites[skill];
  const auto isOfReader = [&](const Site& site) {
    return processes[site.caller].definition == process.definition;
  };
  const auto isOther = [&](const Site& site) { return site.caller != calls.front().caller; };
  return std::ranges::any_of(calls, isOther) && std::ranges::any_of(calls, isOfReader) &&
         readsBeforeCall(process, id, skill);
}

bool System::hasTwoMeanings(ProcessId reader, VariableId id) const {
  const Variable& variable = shared[id];
  const Process& process = processes[reader];
  if (variable.kind != VariableKind::Status && variable.kind != VariableKind::Result) return false;
  if (process.kind != ProcessKind::Skill && process.kind != ProcessKind::Branch) return false;
  const auto& calls = sites[skillProcess[variable.definition]];
  const auto isOfReader = [&](const Site& site) {
    return processes[site.caller].definition == process.definition;
  };
  const IdSet& within = activities[skillProcess[process.definition]];
  return std::ranges::any_of(calls, isOfReader) &&
         std::ranges::any_of(calls, [&](const Site& site) {
           return !isOfReader(site) && within.contains(site.caller);
         });
}

bool System::readsBeforeCall(const Process& reader, VariableId variable, ProcessId skill) const {
  std::vector<bool> seen(reader.graph->nodes.size());
  std::vector<NodeId> todo{0};
  while (!todo.empty()) {
    const NodeId at = todo.back();
    todo.pop_back();
    if (at == kNoNode || seen[at]) continue;
    seen[at] = true;
    const Node& node = (*reader.graph)[at];
    std::vector<VariableId> reads;
    for (const syntax::Expr* condition : node.conditions) names.addReads(*condition, reads);
    if (std::ranges::count(reads, variable) > 0) return true;
    if (node.kind == NodeKind::Call && reader.actions[at].target == skill) continue;
    for (const Edge& edge : node.edges) todo.push_back(edge.target);
  }
  return false;
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
    stopIfAsked();
    skillProcess.push_back(static_cast<ProcessId>(processes.size()));
    addThreads(graphs.emplace_back(buildGraph(source.skills.all[i].node())), ProcessKind::Skill, i);
  }
  for (std::size_t i = 0; i < source.environments.all.size(); ++i)
    addThreads(graphs.emplace_back(buildGraph(source.environments.all[i].node())),
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
  // branches come after the thread that forks them, in the order of the graphs
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
    const syntax::Skill& skill = source.skills.all[i].node();
    bool free = candidates.empty() && !skill.isComposite();
    process.root |= free || (skill.monitor && skill.isComposite());
    process.repeats = free || (process.root && skill.armed);
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

void System::findActivities() {
  std::vector<std::vector<ProcessId>> started;
  for (const Process& process : processes) started.push_back(startedBy(process));
  calls.emplace(std::move(started));
  activities.resize(processes.size());
  for (ProcessId id = 0; id < processes.size(); ++id) {
    activities[id].insert(id);
    allProcesses.insert(id);
  }
  calls->closeOver(activities);
  for (const Process& root : processes)
    if (root.root)
      forEach(activities[&root - processes.data()],
              [this](std::size_t id) { processes[id].analysed = true; });
}

/// Each member of the group, with everything that it calls, runs in parallel with the others.
void System::letRunTogether(const std::vector<ProcessId>& group) {
  IdSet all;
  IdSet twice; ///< skills that several of them call, which run in parallel with themselves
  for (ProcessId id : group) {
    twice.insertAll(all.common(activities[id]));
    all.insertAll(activities[id]);
  }
  for (ProcessId id : group) {
    IdSet own = activities[id];
    own.eraseAll(twice);
    IdSet rest = all;
    rest.eraseAll(own);
    forEach(activities[id], [&](std::size_t each) { others[each].insertAll(rest); });
  }
}

void System::letRunBeside(const std::vector<ProcessId>& some, const std::vector<ProcessId>& rest) {
  IdSet left;
  IdSet right;
  for (ProcessId id : some) left.insertAll(activities[id]);
  for (ProcessId id : rest) right.insertAll(activities[id]);
  forEach(left, [&](std::size_t id) { others[id].insertAll(right); });
  forEach(right, [&](std::size_t id) { others[id].insertAll(left); });
}

void System::findConcurrency() {
  others.resize(processes.size());
  std::vector<ProcessId> alternatives;
  std::vector<ProcessId> always;
  for (ProcessId id = 0; id < eventProcess; ++id)
    if (processes[id].root)
      (std::ranges::count(candidates, id) > 0 ? alternatives : always).push_back(id);
  letRunTogether(always);
  letRunBeside(alternatives, always);
  for (const Process& process : processes)
    for (const Action& action : process.actions) letRunTogether(action.branches);
  for (ProcessId id = 0; id < processes.size(); ++id) {
    if (hasFreeEvents()) others[id].insert(eventProcess);
    others[id].erase(id);
  }
}

void System::chooseSlots() {
  std::vector<IdSet> own;
  IdSet readAnywhere;
  for (ProcessId id = 0; id < processes.size(); ++id) {
    own.push_back(readsOf(id));
    readAnywhere.insertAll(own.back());
  }
  written.resize(processes.size());
  for (ProcessId id = 0; id < processes.size(); ++id)
    for (VariableId variable : writesOf(*this, processes[id])) written[id].insert(variable);
  for (ProcessId id = 0; id < processes.size(); ++id)
    own[id].insertAll(written[id].common(readAnywhere));
  calls->closeOver(written);
  std::size_t nodes = 0;
  for (const Process& process : processes) nodes += process.actions.size();
  std::vector<IdSet> inherited =
      calls->inherited(own, kMostInherited / std::max<std::size_t>(nodes, 1));
  for (ProcessId id = 0; id < processes.size(); ++id) {
    const auto all = followed(own[id], inherited[id], processes[id].actions.size());
    std::vector<VariableId> variables;
    forEach(all, [&](std::size_t variable) {
      const auto each = static_cast<VariableId>(variable);
      if (!hasTwoMeanings(id, each)) variables.push_back(each);
    });
    processes[id].slots = Slots(std::move(variables));
    const auto kind = processes[id].kind;
    if (kind == ProcessKind::Skill || kind == ProcessKind::Branch)
      processes[id].slots.skill = processes[id].definition;
  }
}

bool System::hasFreeEvents() const {
  if (hasFreeInterrupts()) return true;
  return std::ranges::any_of(source.events.all,
                             [](const auto& event) { return event->every.has_value(); });
}

IdSet System::readsOf(ProcessId id) const {
  const Process& process = processes[id];
  std::vector<VariableId> reads;
  if (process.graph)
    addReads(*this, process, reads);
  else
    for (const auto& event : source.events.all) {
      if (event->guard) names.addReads(*event->guard, reads);
      addReads(event->effects, names, shared, reads);
    }
  IdSet set;
  for (VariableId variable : reads) set.insert(variable);
  return set;
}

void System::compile() {
  for (Process& process : processes) {
    stopIfAsked();
    compileActions(*this, process);
  }
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
