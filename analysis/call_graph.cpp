#include "analysis/call_graph.h"

#include "analysis/walk.h"

namespace proskill::analysis {

CallGraph::CallGraph(const Program& program) : program(program) {
  for (const auto& skill : program.skills.all)
    calls.push_back(skill->body ? in(*skill->body) : std::vector<Call>());
}

std::vector<CallGraph::Call> CallGraph::in(const syntax::Block& block) const {
  std::vector<Call> found;
  forEachStatement(block, [&](const syntax::Statement& statement) {
    if (statement.kind != syntax::StatementKind::Call) return;
    auto callee = program.skills.byName.find(statement.head.text);
    if (callee != program.skills.byName.end()) found.push_back({callee->second, &statement});
  });
  return found;
}

} // namespace proskill::analysis
