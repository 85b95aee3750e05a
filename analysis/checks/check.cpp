#include "analysis/checks/checks.h"
#include "analysis/checks/deprecated.h"
#include "analysis/names/reuse.h"
#include "analysis/names/unknown_names.h"
#include "analysis/program/stop.h"

namespace proskill::analysis {

namespace {

struct Check {
  void (*run)(Context&);
  bool ofDefinitions; ///< checks definitions one by one, according to the context's scope
};

constexpr Check kChecks[] = {
    {checkConstants, true}, {checkStateVariables, true}, {checkEvents, true},
    {checkResources, true}, {checkSkills, true},         {checkBodies, true},
    {checkControl, true},   {checkProperties, true},     {checkDuplicates, false},
    {checkFields, true},    {checkIntervals, true},      {checkRecursion, false},
    {checkParallel, false}, {checkStart, false},         {checkReserved, true}};

Analysis analyse(const Program& program, const Earlier* earlier) {
  SymbolTable symbols =
      earlier ? SymbolTable(program, earlier->program, earlier->analysis.index.symbols())
              : SymbolTable(program);
  auto reuse = earlier ? Reuse::find(*earlier, program, symbols) : std::nullopt;
  const CallGraph calls(program);
  Findings all(program.diagnostics);
  std::vector<Occurrence> occurrences;
  std::vector<Found> ofDefinitions;
  for (const Check& check : kChecks) {
    stopIfAsked();
    Findings findings;
    Context context{program, symbols, calls, findings, occurrences};
    if (check.ofDefinitions && reuse) {
      findings.add(reuse->found()[ofDefinitions.size()]);
      context.scope = reuse->scope();
    }
    check.run(context);
    auto found = std::move(findings).asFound();
    all.add(found);
    if (check.ofDefinitions) ofDefinitions.push_back(std::move(found));
  }
  Index index = reuse ? std::move(*reuse).index(std::move(symbols), std::move(occurrences))
                      : Index(std::move(symbols), std::move(occurrences));
  Findings ofNames;
  reportUnknownNames(program, index, all.unknownNames(), ofNames);
  reportDeprecated(program, index, ofNames);
  all.add(std::move(ofNames).asFound());
  return {std::move(index), std::move(all).inOrder(), std::move(ofDefinitions)};
}

} // namespace

Analysis analyse(const Program& program) { return analyse(program, nullptr); }

Analysis analyse(const Program& program, const Earlier& earlier) {
  return analyse(program, &earlier);
}

std::vector<syntax::Diagnostic> check(const Program& program) {
  return analyse(program).diagnostics;
}

} // namespace proskill::analysis
