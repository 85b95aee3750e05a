#include "analysis/flow/flow.h"

#include "analysis/flow/checks/checks.h"
#include "analysis/program/stop.h"

namespace proskill::analysis::flow {

namespace {

constexpr void (*kChecks[])(Report&) = {
    checkMoves,          checkPreconditions, checkEventGuards,   checkStatuses,
    checkWaits,          checkTests,         checkUnreachable,   checkInvariants,
    checkPostconditions, checkInterrupts,    checkUnused,        checkValues,
    checkResults,        checkBranches,      checkResourceOrder, checkSharedSkills,
    checkProgress,       checkRounds,        checkDurations,     checkTicks};

} // namespace

std::vector<syntax::Diagnostic> checkFlow(const Program& program, const Index& index, bool style) {
  return checkFlow(Flow(program), index, style);
}

std::vector<syntax::Diagnostic> checkFlow(const Flow& flow, const Index& index, bool style) {
  Findings findings;
  Report report{flow.system.program(), flow.solver, index, findings};
  noteUnreturned(report);
  for (auto check : kChecks) {
    stopIfAsked();
    check(report);
  }
  if (style) checkStyle(report);
  return std::move(findings).inOrder();
}

} // namespace proskill::analysis::flow
