#include "analysis/flow/result/counters.h"

#include "analysis/flow/result/loops.h"

#include <algorithm>

namespace proskill::analysis::flow {

namespace {

/// The sum of numbers; nullopt: it is too large, or a number is not known.
std::optional<std::int64_t> sumOf(std::optional<std::int64_t> a, std::optional<std::int64_t> b) {
  std::int64_t sum = 0;
  if (!a || !b || __builtin_add_overflow(*a, *b, &sum)) return std::nullopt;
  return sum;
}

/// What the branches of one fork count.
class Counter {
public:
  Counter(const System& system, VariableId variable, const std::vector<ProcessId>& counting)
      : system(system), variable(variable), counting(counting) {}

  std::optional<std::int64_t> most() const {
    for (const Site& fork : forksAround(counting.front())) {
      if (!isAround(fork) || !startsAnew(fork)) continue;
      const auto counted = mostIn(system[fork.caller].actions[fork.node].branches);
      if (counted) return counted;
    }
    return std::nullopt;
  }

private:
  /// The forks that start a branch, directly or indirectly; the innermost first.
  [[nodiscard]] std::vector<Site> forksAround(ProcessId branch) const {
    std::vector<Site> forks;
    for (; system[branch].kind == ProcessKind::Branch; branch = system[branch].parent)
      forks.push_back({system[branch].parent, system[branch].graph->fork});
    return forks;
  }

  [[nodiscard]] bool isAround(const Site& fork) const {
    return std::ranges::all_of(counting, [&](ProcessId branch) {
      return std::ranges::any_of(forksAround(branch), [&](const Site& each) {
        return each.caller == fork.caller && each.node == fork.node;
      });
    });
  }

  /// Whether the natural is set on each way to the fork: from the start, and from the fork itself.
  [[nodiscard]] bool startsAnew(const Site& fork) const {
    const Process& process = system[fork.caller];
    std::vector<bool> seen(process.graph->nodes.size());
    std::vector<NodeId> pending;
    const auto goOn = [&](NodeId from) {
      for (const Edge& edge : (*process.graph)[from].edges)
        if (edge.target != kNoNode && !(edge.sets && sets(process.actions[from])))
          pending.push_back(edge.target);
    };
    goOn(fork.node);
    pending.push_back(0);
    while (!pending.empty()) {
      const NodeId node = pending.back();
      pending.pop_back();
      if (node == fork.node) return false;
      if (seen[node]) continue;
      seen[node] = true;
      goOn(node);
    }
    return true;
  }

  [[nodiscard]] bool sets(const Action& action) const {
    return std::ranges::any_of(action.assignments, [&](const Assignment& each) {
      return each.variable == variable && each.value.kind == Term::Kind::Number;
    });
  }

  [[nodiscard]] std::optional<std::int64_t> mostIn(const std::vector<ProcessId>& branches) const {
    std::optional<std::int64_t> sum = 0;
    for (const ProcessId branch : branches) sum = sumOf(sum, mostIn(branch));
    return sum;
  }

  /// The sum of the steps on the longest path; nullopt: some are in a loop.
  [[nodiscard]] std::optional<std::int64_t> mostIn(ProcessId branch) const {
    const Graph& graph = *system[branch].graph;
    std::vector<std::int64_t> steps(graph.nodes.size());
    std::optional<std::int64_t> all = 0; // no path has more
    for (NodeId node = 0; node < steps.size(); ++node) {
      const auto counted = mostAt(system[branch].actions[node]);
      all = sumOf(all, counted);
      if (!all) return std::nullopt;
      steps[node] = *counted;
    }
    for (const auto& loop : loopsOf(graph, [](NodeId) { return true; }))
      if (std::ranges::any_of(loop, [&](NodeId node) { return steps[node] > 0; }))
        return std::nullopt;
    return longest(graph, steps);
  }

  [[nodiscard]] std::optional<std::int64_t> mostAt(const Action& action) const {
    auto sum = mostIn(action.branches);
    for (const Assignment& each : action.assignments)
      if (each.variable == variable) sum = sumOf(sum, stepOf(each).value_or(0));
    return sum;
  }

  /// \pre no node of a loop has a step. Later nodes mostly have greater numbers.
  static std::int64_t longest(const Graph& graph, const std::vector<std::int64_t>& steps) {
    auto sums = steps;
    for (bool grows = true; grows;) {
      grows = false;
      for (auto node = static_cast<NodeId>(steps.size()); node-- > 0;)
        for (const Edge& edge : graph[node].edges) {
          if (edge.target == kNoNode || steps[node] + sums[edge.target] <= sums[node]) continue;
          sums[node] = steps[node] + sums[edge.target];
          grows = true;
        }
    }
    return sums.front();
  }

  const System& system;
  VariableId variable;
  const std::vector<ProcessId>& counting;
};

} // namespace

Counters::Counters(const System& system) : system(system) {
  for (ProcessId process = 0; process < system.size(); ++process)
    for (const Action& action : system[process].actions)
      for (const Assignment& each : action.assignments) collect(process, each);
}

void Counters::collect(ProcessId process, const Assignment& assignment) {
  auto& [counting, start, isOnlyCounted, most] = changes[assignment.variable];
  const auto step = stepOf(assignment);
  if (step && *step >= 0) {
    if (counting.empty() || counting.back() != process) counting.push_back(process);
  } else if (assignment.value.kind == Term::Kind::Number) {
    start = std::max(start, assignment.value.number);
  } else {
    isOnlyCounted = false;
  }
}

std::optional<std::int64_t> Counters::most(VariableId variable) {
  auto& [counting, start, isOnlyCounted, most] = changes[variable];
  if (!isOnlyCounted || counting.empty()) return std::nullopt;
  if (!most) most = sumOf(start, Counter(system, variable, counting).most());
  return *most;
}

} // namespace proskill::analysis::flow
