#include "analysis/checks/checks.h"

#include "analysis/names/call_graph.h"
#include "graph/components.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>
#include <cstdint>
#include <deque>

namespace proskill::analysis {

namespace {

/// By skill: a representative of its component.
using Components = std::vector<graph::Node>;

Components componentsOf(const CallGraph& graph) {
  return graph::componentsOf(graph.size(), [&](graph::Node skill, std::size_t i) {
    const auto calls = graph.from(skill);
    return i < calls.size() ? static_cast<graph::Node>(calls[i].callee) : graph::kNoNode;
  });
}

/// A call and its caller.
struct Step {
  std::size_t caller;
  const CallGraph::Call* call;
};

/// The shortest cycle through a skill within its component; empty if there is none.
std::vector<Step> shortestCycle(const CallGraph& graph, const Components& components,
                                std::size_t start) {
  std::unordered_map<std::size_t, Step> reachedBy;
  std::deque<std::size_t> waiting{start};
  while (!waiting.empty() && !reachedBy.contains(start)) {
    const std::size_t caller = waiting.front();
    waiting.pop_front();
    for (const CallGraph::Call& call : graph.from(caller))
      if (components[call.callee] == components[start] &&
          reachedBy.try_emplace(call.callee, Step{caller, &call}).second)
        waiting.push_back(call.callee);
  }
  std::vector<Step> cycle;
  if (!reachedBy.contains(start)) return cycle;
  for (std::size_t at = start; cycle.empty() || at != start; at = cycle.back().caller)
    cycle.push_back(reachedBy.at(at));
  std::ranges::reverse(cycle);
  return cycle;
}

void reportCycle(Context& context, const std::vector<Step>& cycle) {
  const auto& skills = context.program.skills.all;
  auto placeOf = [&](const Step& step) {
    return skills[step.caller].atAsRead(step.call->statement->head.range);
  };
  const Step& last = cycle.back();
  auto finding = context.findings.report(syntax::Code::RecursiveSkill, placeOf(last),
                                         skills[last.call->callee].name());
  for (const Step& step : std::span(cycle).first(cycle.size() - 1))
    finding.related(placeOf(step), "`" + std::string(skills[step.caller].name()) + "` calls `" +
                                       std::string(skills[step.call->callee].name()) + "` here");
}

} // namespace

/// Makes one report for each set of mutually recursive skills: the shortest cycle through the
/// first.
void checkRecursion(Context& context) {
  const CallGraph& graph = context.calls;
  const Components components = componentsOf(graph);
  std::vector<bool> reported(graph.size(), false);
  for (std::size_t skill = 0; skill < graph.size(); ++skill) {
    const graph::Node component = components[skill];
    if (reported[component]) continue;
    reported[component] = true;
    const auto cycle = shortestCycle(graph, components, skill);
    if (!cycle.empty()) reportCycle(context, cycle);
  }
}

} // namespace proskill::analysis
