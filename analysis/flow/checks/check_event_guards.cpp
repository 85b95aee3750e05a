#include "analysis/flow/checks/checks.h"
#include "syntax/diagnostics/codes.h"

/// Finds events that never occur since their guard is false, and guards that are always true.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;

void checkGuard(Report& report, const Definition<syntax::Event>& event, const Process& process,
                const std::vector<Condition>& guard) {
  const State ever = everyState(report, process);
  if (!mayHoldTogether(ever, guard)) {
    if (isBlamed(report, process, guard)) return;
    Finding finding =
        report.findings.report(Code::EventNeverOccurs, event.at(event->guard->range), event.name());
    addValues(finding, report, process, ever, guard);
  } else if (!mayFailBeside(anyState(report, process), {}, guard.front())) {
    report.findings.report(Code::EventGuardAlwaysHolds, event.at(event->guard->range),
                           event.name());
  }
}

} // namespace

void checkEventGuards(Report& report) {
  const Process& process = report.system()[report.system().ofEvents()];
  const auto& events = report.program.events.all;
  for (std::size_t event = 0; event < events.size(); ++event)
    if (events[event]->guard)
      checkGuard(report, events[event], process, process.actions[event].conditions);
}

} // namespace proskill::analysis::flow
