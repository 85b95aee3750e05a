#include "analysis/names/call_graph.h"
#include "analysis/program/program.h"

namespace proskill::analysis {

MainSkill mainSkill(const Program& program) { return mainSkill(program, CallGraph(program)); }

MainSkill mainSkill(const Program& program, const CallGraph& graph) {
  std::vector<bool> called(graph.size(), false);
  for (std::size_t caller = 0; caller < graph.size(); ++caller)
    for (const CallGraph::Call& call : graph.from(caller))
      if (call.callee != caller) called[call.callee] = true;
  MainSkill result;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const auto& skill = program.skills.all[i].nodeAsRead();
    if (skill.isComposite() && !skill.monitor && !called[i])
      result.candidates.push_back(&program.skills.all[i]);
  }
  if (result.candidates.size() == 1) result.skill = result.candidates.front();
  return result;
}

} // namespace proskill::analysis
