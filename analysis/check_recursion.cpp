#include "analysis/checks.h"

#include "analysis/call_graph.h"
#include "syntax/codes.h"

#include <algorithm>
#include <cstdint>
#include <deque>

namespace proskill::analysis {

namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// The strongly connected components of a call graph, after R. Tarjan, "Depth-first search and
/// linear graph algorithms", SIAM J. Comput. 1 (1972); with a stack of its own, as a chain of calls
/// may be as long as the program.
class Components {
public:
  explicit Components(const CallGraph& graph)
      : graph(graph),
        number(graph.size(), kNone),
        low(graph.size(), 0),
        component(graph.size(), kNone) {
    for (std::uint32_t skill = 0; skill < graph.size(); ++skill)
      if (number[skill] == kNone) search(skill);
  }

  [[nodiscard]] std::uint32_t of(std::size_t skill) const { return component[skill]; }

private:
  struct Frame {
    std::uint32_t skill;
    std::size_t nextCall;
  };

  void enter(std::uint32_t skill) {
    number[skill] = low[skill] = counter++;
    open.push_back(skill);
    frames.push_back({skill, 0});
  }

  void search(std::uint32_t root) {
    enter(root);
    while (!frames.empty()) {
      Frame& frame = frames.back();
      const std::uint32_t skill = frame.skill;
      if (frame.nextCall == graph.from(skill).size()) {
        leave(skill);
        continue;
      }
      const auto callee = static_cast<std::uint32_t>(graph.from(skill)[frame.nextCall++].callee);
      if (number[callee] == kNone)
        enter(callee);
      else if (component[callee] == kNone)
        low[skill] = std::min(low[skill], number[callee]);
    }
  }

  void leave(std::uint32_t skill) {
    frames.pop_back();
    if (!frames.empty()) {
      std::uint32_t& caller = low[frames.back().skill];
      caller = std::min(caller, low[skill]);
    }
    if (low[skill] != number[skill]) return;
    for (std::uint32_t member = kNone; member != skill; open.pop_back())
      component[member = open.back()] = skill;
  }

  const CallGraph& graph;
  std::vector<std::uint32_t> number, low, component, open;
  std::vector<Frame> frames;
  std::uint32_t counter = 0;
};

/// A call and who makes it.
struct Step {
  std::size_t caller;
  const CallGraph::Call* call;
};

/// The shortest way from a skill back to itself within its component; empty where there is none.
std::vector<Step> shortestCycle(const CallGraph& graph, const Components& components,
                                std::size_t start) {
  std::unordered_map<std::size_t, Step> reachedBy;
  std::deque<std::size_t> waiting{start};
  while (!waiting.empty() && !reachedBy.contains(start)) {
    const std::size_t caller = waiting.front();
    waiting.pop_front();
    for (const CallGraph::Call& call : graph.from(caller))
      if (components.of(call.callee) == components.of(start) &&
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
    return skills[step.caller].at(step.call->statement->head.range);
  };
  const Step& last = cycle.back();
  auto finding = context.findings.report(syntax::Code::RecursiveSkill, placeOf(last),
                                         skills[last.call->callee].name());
  for (const Step& step : std::span(cycle).first(cycle.size() - 1))
    finding.related(placeOf(step), "`" + std::string(skills[step.caller].name()) + "` calls `" +
                                       std::string(skills[step.call->callee].name()) + "` here");
}

} // namespace

/// One report for each set of skills that call each other: the shortest cycle through its first.
void checkRecursion(Context& context) {
  const CallGraph graph(context.program);
  const Components components(graph);
  std::vector<bool> reported(graph.size(), false);
  for (std::size_t skill = 0; skill < graph.size(); ++skill) {
    const std::uint32_t component = components.of(skill);
    if (reported[component]) continue;
    reported[component] = true;
    const auto cycle = shortestCycle(graph, components, skill);
    if (!cycle.empty()) reportCycle(context, cycle);
  }
}

} // namespace proskill::analysis
