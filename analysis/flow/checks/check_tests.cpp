#include "analysis/flow/checks/checks.h"
#include "syntax/diagnostics/codes.h"

/// Finds conditions of `if`, `while` and `do` that are always true or always false.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;
using syntax::StatementKind;

/// `(while true …)` and `(do … until false)` are the idioms for endless loops.
bool isIdiom(const Node& node, const Condition& condition) {
  return condition.kind == Condition::Kind::Constant && node.statement->kind != StatementKind::If;
}

/// Whether another arm follows, which a condition that is always true makes unreachable.
bool hasOtherArm(const Node& node) {
  const syntax::Statement& statement = *node.statement;
  return statement.kind == StatementKind::If &&
         (!statement.arms.back().condition || statement.arms.back().condition->range != node.range);
}

void checkTest(Report& report, ProcessId id, NodeId nodeId, const Node& node) {
  const Process& process = report.system()[id];
  const auto& conditions = process.actions[nodeId].conditions;
  if (isIdiom(node, conditions.front())) return;
  bool never = !report.solver.mayHold(id, nodeId, conditions.front());
  bool always = !report.solver.mayFail(id, nodeId, conditions.front());
  if (!never && !always) return;
  report.explain(id, nodeId);
  if (isBlamed(report, process, conditions)) return;
  if (dependsOnUnreturned(report, id, nodeId, conditions.front(), never)) return;
  bool loops = node.statement->kind == StatementKind::While;
  using Told = syntax::CodeFor<0>;
  const auto code = always  ? Told(Code::TestAlwaysHolds)
                    : loops ? Told(Code::LoopNeverEntered)
                            : Told(Code::TestNeverHolds);
  Finding finding = report.findings.report(code, report.at(id, nodeId));
  if (always && !hasOtherArm(node)) finding.severity(syntax::Severity::Hint);
  addValues(finding, report, process, report.solver.before(id, nodeId), conditions);
}

} // namespace

void checkTests(Report& report) {
  forEachReachedNode(report, [&](ProcessId id, const Process&, NodeId node, const Node& each) {
    // the arms of a `case` are required for all declared outcomes, even for impossible ones
    if (each.kind == NodeKind::Test && each.statement->kind != StatementKind::Case &&
        !report.isExplained(id, node))
      checkTest(report, id, node, each);
  });
}

} // namespace proskill::analysis::flow
