#include "analysis/flow/checks/loop_statement.h"

#include <algorithm>

namespace proskill::analysis::flow {

namespace {

bool isLoop(const syntax::Statement& statement) {
  return statement.kind == syntax::StatementKind::While ||
         statement.kind == syntax::StatementKind::DoUntil;
}

} // namespace

const syntax::Statement& loopStatement(const Process& process, const std::vector<NodeId>& loop) {
  const syntax::Statement* found = nullptr;
  for (NodeId node : loop) {
    const syntax::Statement* each = (*process.graph)[node].statement;
    if (isLoop(*each) && (!found || each->range.begin < found->range.begin)) found = each;
  }
  return found ? *found : *(*process.graph)[*std::ranges::min_element(loop)].statement;
}

Location beginOf(const Report& report, const Process& process, const syntax::Statement& loop) {
  return report.system().at(process, loop.head.range.empty() ? loop.range : loop.head.range);
}

void offerWait(Finding& finding, const Report& report, const Process& process,
               const syntax::Statement& loop) {
  if (!isLoop(loop) || loop.branches.empty()) return;
  const auto& statements = loop.branches.front().statements;
  if (statements.empty()) return;
  const Location last = report.system().at(process, statements.back().range);
  finding.fix("wait 0.1 s in each round", {last.file, {last.range.end, last.range.end}},
              lineAfter(report, last) + "(^ 0.1)");
}

} // namespace proskill::analysis::flow
