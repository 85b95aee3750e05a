#include "analysis/flow/checks/checks.h"
#include "syntax/diagnostics/codes.h"
#include "syntax/tree/statements.h"

/// Finds waits for conditions that are never true, or already true.
namespace proskill::analysis::flow {

namespace {

void checkWait(Report& report, ProcessId id, NodeId nodeId) {
  const Process& process = report.system()[id];
  const auto& conditions = process.actions[nodeId].conditions;
  const State before = report.solver.before(id, nodeId);
  if (conditions.front().kind == Condition::Kind::Constant) return; // probably intended
  const Node& node = (*process.graph)[nodeId];
  Location at = report.system().at(process, node.statement->condition.range);
  if (!report.solver.mayHold(id, nodeId, conditions.front())) {
    report.explain(id, nodeId);
    if (isBlamed(report, process, conditions)) return;
    if (dependsOnUnreturned(report, id, nodeId, conditions.front(), true)) return;
    if (syntax::hasTimeout(*node.statement)) return; // it ends, so it may be intended
    Finding finding = report.findings.report(syntax::Code::WaitNeverEnds, at);
    addValues(finding, report, process, before, conditions);
  } else if (!report.solver.mayFail(id, nodeId, conditions.front()) &&
             node.effects->items.empty()) {
    Finding finding = report.findings.report(syntax::Code::WaitAlreadyHolds, at);
    addValues(finding, report, process, before, conditions);
    finding.fix("remove the wait", withSpaceAround(report, report.at(id, nodeId)), "");
  }
}

} // namespace

void checkWaits(Report& report) {
  forEachReachedNode(report, [&](ProcessId id, const Process&, NodeId node, const Node& each) {
    if (each.kind == NodeKind::Wait && !report.isExplained(id, node)) checkWait(report, id, node);
  });
}

} // namespace proskill::analysis::flow
