#include "analysis/flow/flow.h"

#include "analysis/flow/checks.h"

namespace proskill::analysis::flow {

namespace {

constexpr void (*kChecks[])(Report&) = {
    checkMoves,       checkPreconditions, checkStatuses,       checkWaits,         checkTests,
    checkUnreachable, checkInvariants,    checkPostconditions, checkInterrupts,    checkValues,
    checkUnused,      checkResults,       checkBranches,       checkResourceOrder, checkProgress,
    checkDurations,   checkTicks,         checkStyle};

} // namespace

std::vector<syntax::Diagnostic> checkFlow(const Program& program, const Index& index) {
  System system(program);
  Solver solver(system);
  Findings findings({});
  Report report{program, solver, index, findings};
  for (auto check : kChecks) check(report);
  return std::move(findings).inOrder();
}

} // namespace proskill::analysis::flow
