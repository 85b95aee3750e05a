#include "analysis/flow/checks.h"
#include "syntax/codes.h"

#include <map>

/// Postconditions that are false whenever their outcome comes.
namespace proskill::analysis::flow {

namespace {

/// Over all the nodes that return one outcome.
struct Returned {
  ProcessId process = kNoProcess;
  State after;
};

} // namespace

void checkPostconditions(Report& report) {
  std::map<const syntax::Outcome*, Returned> outcomes;
  forEachReachedNode(report, [&](ProcessId id, const Process& process, NodeId node,
                                 const Node& each) {
    if (each.kind != NodeKind::Outcome || !each.outcome || !each.outcome->postcondition) return;
    Returned& returned = outcomes[each.outcome];
    returned.process = id;
    returned.after.join(report.solver.afterEffects(report.solver.before(id, node), process, node));
  });
  for (const auto& [outcome, returned] : outcomes) {
    const Process& process = report.system()[returned.process];
    Condition condition =
        report.system().resolver().condition(*outcome->postcondition, process.slots);
    if (mayHold(returned.after, condition)) continue;
    Finding finding = report.findings.report(
        syntax::Code::PostconditionNeverHolds,
        report.system().at(process, outcome->postcondition->range), outcome->tag.text);
    addValues(finding, report, process, returned.after, {condition});
  }
}

} // namespace proskill::analysis::flow
