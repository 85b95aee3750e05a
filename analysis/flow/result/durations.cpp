#include "analysis/flow/result/durations.h"

#include "analysis/flow/result/loops.h"

#include "syntax/tree/statements.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <utility>

namespace proskill::analysis::flow {

namespace {

using syntax::Rational;

std::optional<Rational> sum(std::optional<Rational> a, std::optional<Rational> b) {
  if (!a || !b) return std::nullopt;
  return syntax::add(*a, *b);
}

Duration ofInterval(const std::optional<syntax::Interval>& interval) {
  if (!interval) return {{0, 1}, std::nullopt};
  return {interval->lower, interval->upper};
}

} // namespace

Durations::Durations(const Solver& solver)
    : solver(solver), system(solver.system()), known(system.size()), busy(system.size()) {}

/// With an explicit stack, since chains of calls may be long.
std::optional<Duration> Durations::of(ProcessId process) {
  std::vector<ProcessId> stack{process};
  while (!stack.empty()) {
    ProcessId next = stack.back();
    if (known[next] || isReady(next, stack)) {
      if (!known[next]) compute(next);
      busy[next] = false;
      stack.pop_back();
    } else {
      busy[next] = true;
    }
  }
  return known[process]->whole;
}

/// Adds the callees whose durations are unknown, unless they are being computed.
bool Durations::isReady(ProcessId process, std::vector<ProcessId>& needed) const {
  const std::size_t before = needed.size();
  auto need = [&](ProcessId other) {
    if (other != kNoProcess && other != process && !known[other] && !busy[other])
      needed.push_back(other);
  };
  for (NodeId node = 0; node < system[process].actions.size(); ++node) {
    if (!solver.reachable(process, node)) continue;
    if ((*system[process].graph)[node].kind == NodeKind::Call)
      need(system[process].actions[node].target);
    for (ProcessId branch : system[process].actions[node].branches) need(branch);
  }
  return needed.size() == before;
}

void Durations::compute(ProcessId process) {
  const Unrolled ways = unrolled(solver, process);
  std::map<NodeId, Duration> once;
  std::vector<Duration> times;
  for (NodeId node : ways.original) {
    auto entry = once.find(node);
    if (entry == once.end()) entry = once.emplace(node, ofNode(process, node)).first;
    times.push_back(entry->second);
  }
  Known& result = known[process].emplace();
  result.latestExit = latestExit(ways, times);
  if (Date least = earliestEnd(ways, times)) result.whole = Duration{*least, result.latestExit};
}

/// Its callee may be refused, stopped, or fail an invariant at any time.
bool Durations::mayEndEarly(ProcessId skill) const {
  if (solver.mayBeInterrupted(skill)) return true;
  const Graph& graph = *system[skill].graph;
  for (NodeId node = 0; node < graph.nodes.size(); ++node)
    if (graph[node].kind == NodeKind::InvariantFailure && solver.reachable(skill, node))
      return true;
  return false;
}

/// Whether the call may have to wait until the skill or its resources are free.
bool Durations::mayBeAwaited(ProcessId caller, ProcessId callee) const {
  return system.concurrent(caller).contains(callee) ||
         !system.skill(system[callee]).resources.empty();
}

Duration Durations::ofCall(ProcessId process, NodeId node) {
  ProcessId callee = system[process].actions[node].target;
  if (callee == kNoProcess) return {{0, 1}, std::nullopt};
  bool mayBeRefused = false;
  if (!system[callee].actions[0].conditions.empty())
    for (State entry : solver.atCallee(process, node)) {
      refineAll(entry, system[callee].actions[0].conditions, false);
      mayBeRefused |= entry.reachable;
    }
  Duration duration{{0, 1}, std::nullopt};
  if (known[callee] && known[callee]->whole) duration = *known[callee]->whole;
  if (mayBeRefused || mayEndEarly(callee)) duration.least = {0, 1};
  if (mayBeAwaited(process, callee)) duration.most = std::nullopt;
  return duration;
}

Duration Durations::ofFork(ProcessId process, NodeId node) {
  if ((*system[process].graph)[node].isRace()) return ofRace(process, node);
  Duration all{{0, 1}, Rational{0, 1}};
  for (ProcessId branch : system[process].actions[node].branches) {
    if (!known[branch]) return {{0, 1}, std::nullopt};
    // a branch that ends the whole skill, or never ends, has no end of its own
    if (known[branch]->whole) all.least = std::max(all.least, known[branch]->whole->least);
    const Date& last = known[branch]->latestExit;
    all.most = all.most && last ? Date(std::max(*all.most, *last)) : std::nullopt;
  }
  return all;
}

/// The duration of the fastest branch, unless a branch has called a skill that must not be stopped,
/// for which all wait.
Duration Durations::ofRace(ProcessId process, NodeId node) {
  Date least;
  Date first;
  Date held = Rational{0, 1};
  for (ProcessId branch : system[process].actions[node].branches) {
    if (!known[branch]) return {{0, 1}, std::nullopt};
    const Date& last = known[branch]->latestExit;
    if (last && (!first || *last < *first)) first = last;
    if (mayHoldOut(branch)) held = held && last ? Date(std::max(*held, *last)) : std::nullopt;
    if (!known[branch]->whole) continue;
    least = least ? std::min(*least, known[branch]->whole->least) : known[branch]->whole->least;
  }
  const Date most = first && held ? Date(std::max(*first, *held)) : std::nullopt;
  return {least.value_or(Rational{0, 1}), most};
}

bool Durations::mayHoldOut(ProcessId branch) const {
  bool found = false;
  forEach(system.activity(branch), [&](std::size_t id) {
    const Process& each = system[static_cast<ProcessId>(id)];
    found |= each.kind == ProcessKind::Skill && system.skill(each).unstoppable;
  });
  return found;
}

Duration Durations::ofNode(ProcessId process, NodeId id) {
  const Node& node = (*system[process].graph)[id];
  switch (node.kind) {
  case NodeKind::Run: return ofInterval(system.skill(system[process]).timeInterval);
  case NodeKind::Call: return ofCall(process, id);
  case NodeKind::Fork: return ofFork(process, id);
  case NodeKind::Delay: return ofInterval(node.statement->duration);
  case NodeKind::Wait:
    if (!solver.mayFail(process, id, system[process].actions[id].conditions.front()))
      return {{0, 1}, Rational{0, 1}};
    return {{0, 1},
            syntax::hasTimeout(*node.statement) ? node.statement->duration.upper : std::nullopt};
  case NodeKind::Emit:
    if (takesNoTime(system[process], id)) return {{0, 1}, Rational{0, 1}};
    return {{0, 1}, std::nullopt};
  case NodeKind::Start:
  case NodeKind::Refused:
  case NodeKind::Interrupt:
  case NodeKind::Test:
  case NodeKind::Choose:
  case NodeKind::Set:
  case NodeKind::Step:
  case NodeKind::Leave:
  case NodeKind::Outcome:
  case NodeKind::InvariantFailure:
  case NodeKind::Interrupted:
  case NodeKind::End: return {{0, 1}, Rational{0, 1}};
  }
  std::unreachable();
}

/// The shortest path; nullopt if there is none. By relaxation, which needs few rounds since bodies
/// are almost acyclic. R. Bellman, "On a routing problem", 1958.
Durations::Date Durations::earliestEnd(const Unrolled& ways, const std::vector<Duration>& times) {
  const Graph& graph = ways.graph;
  std::vector<Date> dates(graph.nodes.size());
  for (NodeId node = 0; node < graph.nodes.size(); ++node)
    if (graph[node].kind == NodeKind::Start) dates[node] = Rational{0, 1};
  for (bool changed = true; changed;) {
    changed = false;
    for (NodeId node = 0; node < graph.nodes.size(); ++node) {
      if (!dates[node]) continue;
      for (const Edge& edge : graph[node].edges) {
        NodeKind kind = graph[edge.target].kind;
        if (kind == NodeKind::InvariantFailure || kind == NodeKind::Interrupted) continue;
        // a branch that ends the skill may do so at any time during the fork
        Date date = edge.stops ? dates[node] : sum(dates[node], times[node].least);
        if (dates[edge.target] && *dates[edge.target] <= *date) continue;
        dates[edge.target] = date;
        changed = true;
      }
    }
  }
  return graph.end == kNoNode ? Date() : dates[graph.end];
}

/// The longest path to the end, or to where a branch ends its skill; nullopt if it is unbounded.
Durations::Date Durations::latestExit(const Unrolled& ways, const std::vector<Duration>& times) {
  const Graph& graph = ways.graph;
  if (!loopsOf(graph, [](NodeId) { return true; }).empty()) return std::nullopt;
  std::vector<Date> dates(graph.nodes.size());
  for (NodeId node = 0; node < graph.nodes.size(); ++node)
    if (graph[node].kind == NodeKind::Start) dates[node] = Rational{0, 1};
  for (bool changed = true; changed;) {
    changed = false;
    for (NodeId node = 0; node < graph.nodes.size(); ++node) {
      if (!dates[node]) continue;
      Date leaving = sum(dates[node], times[node].most);
      if (!leaving) return std::nullopt; // it may stay there, whatever edges leave it
      for (const Edge& edge : graph[node].edges) {
        if (dates[edge.target] && *dates[edge.target] >= *leaving) continue;
        dates[edge.target] = leaving;
        changed = true;
      }
    }
  }
  Date last;
  for (NodeId node = 0; node < graph.nodes.size(); ++node) {
    bool exits = node == graph.end || graph[node].kind == NodeKind::Leave;
    if (exits && dates[node]) last = std::max(last, dates[node]);
  }
  return last;
}

std::string words(const Duration& duration) {
  if (!duration.most) return fmt::format("at least {} s", toString(duration.least));
  if (duration.least == *duration.most) return fmt::format("{} s", toString(duration.least));
  return fmt::format("{} to {} s", toString(duration.least), toString(*duration.most));
}

} // namespace proskill::analysis::flow
