#include "analysis/checks/checks.h"
#include "syntax/diagnostics/codes.h"

namespace proskill::analysis {

using syntax::Code;

namespace {

void checkNames(Context& context) {
  for (const Duplicate& duplicate : context.symbols.duplicates()) {
    const Symbol& first = context.symbols[duplicate.first];
    const Symbol& second = context.symbols[duplicate.second];
    if (second.kind == SymbolKind::Environment) continue;
    const bool inside = second.owner != kNoSymbol;
    const syntax::CodeFor<2> code = inside ? syntax::CodeFor<2>(Code::DuplicateName)
                                           : syntax::CodeFor<2>(Code::DuplicateDefinition);
    context.findings.report(code, second.at, words(second.kind), second.name)
        .related(first.at, "first defined here");
  }
}

/// A program has one environment, whatever its name.
void checkEnvironments(Context& context) {
  const auto& all = context.program.environments.all;
  for (std::size_t i = 1; i < all.size(); ++i)
    context.findings.report(Code::SecondEnvironment, all[i].at(all[i]->name.range))
        .related(all[0].at(all[0]->name.range), "the first one");
}

} // namespace

void checkDuplicates(Context& context) {
  checkNames(context);
  checkEnvironments(context);
}

} // namespace proskill::analysis
