#include "analysis/flow/checks.h"
#include "syntax/codes.h"

#include <algorithm>
#include <map>

/// Postconditions that are false whenever their outcome comes.
namespace proskill::analysis::flow {

namespace {

/// Over all the nodes that return one outcome.
struct Returned {
  ProcessId process = kNoProcess;
  std::vector<State> after;
};

} // namespace

void checkPostconditions(Report& report) {
  std::map<const syntax::Outcome*, Returned> outcomes;
  forEachReachedNode(
      report, [&](ProcessId id, const Process& process, NodeId node, const Node& each) {
        if (each.kind != NodeKind::Outcome || !each.outcome || !each.outcome->postcondition) return;
        Returned& returned = outcomes[each.outcome];
        returned.process = id;
        for (const State& before : report.solver.cases(id, node))
          returned.after.push_back(report.solver.afterEffects(before, process, node));
      });
  for (const auto& [outcome, returned] : outcomes) {
    const Process& process = report.system()[returned.process];
    Condition condition =
        report.system().resolver().condition(*outcome->postcondition, process.slots);
    auto holds = [&](const State& after) { return mayHold(after, condition); };
    if (std::ranges::any_of(returned.after, holds)) continue;
    State all;
    for (const State& after : returned.after) all.join(after);
    Finding finding = report.findings.report(
        syntax::Code::PostconditionNeverHolds,
        report.system().at(process, outcome->postcondition->range), outcome->tag.text);
    addValues(finding, report, process, all, {condition});
  }
}

} // namespace proskill::analysis::flow
