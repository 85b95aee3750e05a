#include "analysis/flow/checks.h"
#include "syntax/codes.h"

/// Tests of `if`, `while` and `do` that always go the same way.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;
using syntax::StatementKind;

/// `(while true …)` and `(do … until false)` are how a loop without an end is written.
bool isIdiom(const Node& node, const Condition& condition) {
  return condition.kind == Condition::Kind::Constant && node.statement->kind != StatementKind::If;
}

void checkTest(Report& report, ProcessId id, NodeId nodeId, const Node& node) {
  const Process& process = report.system()[id];
  const auto& conditions = process.actions[nodeId].conditions;
  const State& before = report.solver.before(id, nodeId);
  if (isIdiom(node, conditions.front())) return;
  bool never = !mayHold(before, conditions.front());
  bool always = !mayFail(before, conditions.front());
  if (!never && !always) return;
  report.explain(id, nodeId);
  bool loops = node.statement->kind == StatementKind::While;
  Code code = always  ? Code::TestAlwaysHolds
              : loops ? Code::LoopNeverEntered
                      : Code::TestNeverHolds;
  Finding finding = report.findings.report(code, report.at(id, nodeId));
  addValues(finding, report, process, before, conditions);
}

} // namespace

void checkTests(Report& report) {
  forEachReachedNode(report, [&](ProcessId id, const Process&, NodeId node, const Node& each) {
    if (each.kind == NodeKind::Test && !report.isExplained(id, node))
      checkTest(report, id, node, each);
  });
}

} // namespace proskill::analysis::flow
