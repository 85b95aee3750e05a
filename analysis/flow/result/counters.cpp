#include "analysis/flow/result/counters.h"

#include "analysis/flow/result/loops.h"

#include <algorithm>

namespace proskill::analysis::flow {

namespace {

class Counter {
public:
  Counter(const System& system, VariableId variable) : system(system), variable(variable) {}

  std::optional<std::int64_t> most() {
    if (!collect() || counting.empty()) return std::nullopt;
    for (const Site& fork : forksAround(counting.front())) {
      if (!isAround(fork) || !startsAnew(fork)) continue;
      const auto counted = mostIn(system[fork.caller].actions[fork.node].branches);
      if (counted) return start + *counted;
    }
    return std::nullopt;
  }

private:
  /// Finds who counts, and the greatest number to which the natural is set.
  /// \return whether it is changed in no other way
  bool collect() {
    for (ProcessId id = 0; id < system.size(); ++id)
      for (const Action& action : system[id].actions)
        for (const Assignment& each : action.assignments) {
          if (each.variable != variable) continue;
          if (const auto step = stepOf(each); step && *step >= 0)
            counting.push_back(id);
          else if (each.value.kind == Term::Kind::Number)
            start = std::max(start, each.value.number);
          else
            return false;
        }
    return true;
  }

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
    std::int64_t sum = 0;
    for (const ProcessId branch : branches) {
      const auto counted = mostIn(branch);
      if (!counted) return std::nullopt;
      sum += *counted;
    }
    return sum;
  }

  /// The sum of the steps on the longest path; nullopt: some are in a loop.
  [[nodiscard]] std::optional<std::int64_t> mostIn(ProcessId branch) const {
    const Graph& graph = *system[branch].graph;
    std::vector<std::int64_t> steps(graph.nodes.size());
    for (NodeId node = 0; node < steps.size(); ++node) {
      const auto counted = mostAt(system[branch].actions[node]);
      if (!counted) return std::nullopt;
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
      if (sum && each.variable == variable) *sum += stepOf(each).value_or(0);
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
  std::vector<ProcessId> counting;
  std::int64_t start = 0;
};

} // namespace

std::optional<std::int64_t> mostCounted(const System& system, VariableId variable) {
  return Counter(system, variable).most();
}

} // namespace proskill::analysis::flow
