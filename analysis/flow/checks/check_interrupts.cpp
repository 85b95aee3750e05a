#include "analysis/flow/checks/checks.h"
#include "syntax/diagnostics/codes.h"

/// Finds `(x.interrupt)` at places where x cannot have been called.
namespace proskill::analysis::flow {

void checkInterrupts(Report& report) {
  forEachReachedNode(
      report, [&](ProcessId id, const Process& process, NodeId node, const Node& each) {
        ProcessId target = process.actions[node].target;
        if (each.kind != NodeKind::Interrupt || target == kNoProcess) return;
        const System& system = report.system();
        if (!system.skill(system[target]).interrupt) return; // reported by PS0424
        if (!report.solver.started(target))
          return; // another finding says why it is never
                  // called
        VariableId called = report.variables().of(VariableKind::Called, system[target].definition);
        auto slot = process.slots.find(called);
        if (!slot || report.solver.before(id, node).values[*slot].contains(1)) return;
        Finding finding = report.findings.report(syntax::Code::InterruptNotRunning,
                                                 report.at(id, node), each.statement->name.text);
        finding.fix("remove it", withSpaceAround(report, report.at(id, node)), "");
        for (const Site& site : system.callers(target))
          if (site.caller == id) {
            finding.related(report.at(id, site.node), "this call has ended before, or comes later");
            break;
          }
      });
}

} // namespace proskill::analysis::flow
