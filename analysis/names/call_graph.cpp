#include "analysis/names/call_graph.h"

#include "analysis/names/walk.h"

namespace proskill::analysis {

CallGraph::CallGraph(const Program& program) : program(program) {
  firsts.reserve(program.skills.all.size() + 1);
  for (const auto& skill : program.skills.all) {
    firsts.push_back(calls.size());
    for (const auto* call : skill.form->bodyIndexAsRead().calls) add(*call, calls);
  }
  firsts.push_back(calls.size());
}

std::vector<CallGraph::Call> CallGraph::in(const syntax::Block& block) const {
  std::vector<Call> found;
  forEachStatement(block, [&](const syntax::Statement& statement) {
    if (statement.kind == syntax::StatementKind::Call) add(statement, found);
  });
  return found;
}

void CallGraph::add(const syntax::Statement& call, std::vector<Call>& to) const {
  const auto callee = program.skills.byName.find(call.head.text);
  if (callee != program.skills.byName.end()) to.push_back({callee->second, &call});
}

} // namespace proskill::analysis
