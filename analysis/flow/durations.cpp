#include "analysis/flow/durations.h"

#include "analysis/flow/loops.h"

#include <algorithm>
#include <fmt/format.h>

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

std::optional<Duration> Durations::of(ProcessId process) {
  if (busy[process]) return Duration{{0, 1}, std::nullopt};
  if (known[process]) return *known[process];
  busy[process] = true;
  std::optional<Duration> result;
  Date least = earliest(process)[system[process].graph->end];
  if (least) result = Duration{*least, latestExit(process)};
  busy[process] = false;
  known[process] = result;
  return result;
}

/// Its callee may be refused, stopped, or fail an invariant at any time.
bool Durations::mayEndEarly(ProcessId callee) const {
  if (solver.mayBeInterrupted(callee)) return true;
  const Graph& graph = *system[callee].graph;
  for (NodeId node = 0; node < graph.nodes.size(); ++node)
    if (graph[node].kind == NodeKind::InvariantFailure && solver.reachable(callee, node))
      return true;
  return false;
}

/// The call may have to wait until the skill or its resources are free.
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
  auto taken = of(callee);
  Duration duration = taken.value_or(Duration{{0, 1}, std::nullopt});
  if (mayBeRefused || mayEndEarly(callee)) duration.least = {0, 1};
  if (mayBeAwaited(process, callee)) duration.most = std::nullopt;
  return duration;
}

Duration Durations::ofFork(ProcessId process, NodeId node) {
  Duration all{{0, 1}, Rational{0, 1}};
  for (ProcessId branch : system[process].actions[node].branches) {
    // One that ends the whole skill, or never ends, has no end of its own.
    if (auto one = of(branch)) all.least = std::max(all.least, one->least);
    Date last = latestExit(branch);
    all.most = all.most && last ? Date(std::max(*all.most, *last)) : std::nullopt;
  }
  return all;
}

Duration Durations::ofNode(ProcessId process, NodeId id) {
  const Node& node = (*system[process].graph)[id];
  switch (node.kind) {
  case NodeKind::Run: return ofInterval(system.skill(system[process]).timeInterval);
  case NodeKind::Call: return ofCall(process, id);
  case NodeKind::Fork: return ofFork(process, id);
  case NodeKind::Delay: return ofInterval(node.statement->duration);
  case NodeKind::Wait:
    if (solver.mayFail(process, id, system[process].actions[id].conditions.front()))
      return {{0, 1}, std::nullopt};
    return {{0, 1}, Rational{0, 1}};
  default: return {{0, 1}, Rational{0, 1}};
  }
}

/// The shortest ways; nothing where there is none. E. W. Dijkstra 1959, by relaxation: bodies are
/// almost acyclic, so that few rounds do.
std::vector<Durations::Date> Durations::earliest(ProcessId process) {
  const Graph& graph = *system[process].graph;
  std::vector<Date> dates(graph.nodes.size());
  std::vector<Date> cost(graph.nodes.size());
  for (NodeId node = 0; node < graph.nodes.size(); ++node)
    if (solver.reachable(process, node)) cost[node] = ofNode(process, node).least;
  if (cost[0]) dates[0] = Rational{0, 1};
  for (bool changed = true; changed;) {
    changed = false;
    for (NodeId node = 0; node < graph.nodes.size(); ++node) {
      if (!dates[node]) continue;
      for (const Edge& edge : graph[node].edges) {
        if (edge.target == kNoNode || !cost[edge.target]) continue;
        NodeKind kind = graph[edge.target].kind;
        if (kind == NodeKind::InvariantFailure || kind == NodeKind::Interrupted) continue;
        // A branch that ends the skill may do so at any time of the fork.
        Date date = edge.stops ? dates[node] : sum(dates[node], cost[node]);
        if (!date || (dates[edge.target] && *dates[edge.target] <= *date)) continue;
        dates[edge.target] = date;
        changed = true;
      }
    }
  }
  return dates;
}

/// The longest way to the end, or to where a branch ends its skill; nothing where there is none
/// that is longest.
Durations::Date Durations::latestExit(ProcessId process) {
  const Graph& graph = *system[process].graph;
  auto reached = [&](NodeId node) { return solver.reachable(process, node); };
  if (!loopsOf(graph, reached).empty()) return std::nullopt;
  std::vector<Date> dates(graph.nodes.size());
  dates[0] = Rational{0, 1};
  for (bool changed = true; changed;) {
    changed = false;
    for (NodeId node = 0; node < graph.nodes.size(); ++node) {
      if (!dates[node] || !reached(node)) continue;
      Date leaving = sum(dates[node], ofNode(process, node).most);
      for (const Edge& edge : graph[node].edges) {
        if (edge.target == kNoNode || !reached(edge.target)) continue;
        if (!leaving) return std::nullopt;
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
