#include "analysis/checks.h"
#include "analysis/stop.h"

namespace proskill::analysis {

namespace {

constexpr void (*kChecks[])(Context&) = {
    checkStateVariables, checkEvents,     checkResources,  checkSkills, checkBodies,
    checkControl,        checkProperties, checkDuplicates, checkFields, checkIntervals,
    checkRecursion,      checkParallel,   checkStart};

} // namespace

Analysis analyse(const Program& program) {
  SymbolTable symbols(program);
  Findings findings(program.diagnostics);
  std::vector<Occurrence> occurrences;
  Context context{program, symbols, findings, occurrences};
  for (auto check : kChecks) {
    stopIfAsked();
    check(context);
  }
  return {Index(std::move(symbols), std::move(occurrences)), std::move(findings).inOrder()};
}

std::vector<syntax::Diagnostic> check(const Program& program) {
  return analyse(program).diagnostics;
}

} // namespace proskill::analysis
