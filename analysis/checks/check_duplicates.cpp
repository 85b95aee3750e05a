#include "analysis/checks/checks.h"
#include "syntax/diagnostics/codes.h"

#include <set>

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

/// A word that may be a constant may also be one of these.
bool meansSomethingElse(SymbolKind kind) {
  return kind == SymbolKind::StateVariable || kind == SymbolKind::Value ||
         kind == SymbolKind::SuccessTag || kind == SymbolKind::FailureTag ||
         kind == SymbolKind::InvariantTag;
}

void checkConstantNames(Context& context) {
  if (context.program.constants.all.empty()) return;
  std::set<SymbolId> told;
  for (const Symbol& other : context.symbols.all()) {
    if (!meansSomethingElse(other.kind)) continue;
    const SymbolId constant = context.symbols.find(SymbolKind::Constant, other.name);
    if (constant == kNoSymbol || !told.insert(constant).second) continue;
    context.findings
        .report(Code::ConstantNameTaken, context.symbols[constant].at, other.name,
                words(other.kind))
        .related(other.at, "defined here");
  }
}

/// A program has one environment, whatever its name.
void checkEnvironments(Context& context) {
  const auto& all = context.program.environments.all;
  for (std::size_t i = 1; i < all.size(); ++i)
    context.findings.report(Code::SecondEnvironment, all[i].at(all[i]->name.range))
        .related(all[0].at(all[0]->name.range), "the first one");
}

void checkPlatforms(Context& context) {
  const auto& all = context.program.platforms.all;
  for (std::size_t i = 1; i < all.size(); ++i)
    context.findings.report(Code::SecondPlatform, all[i].at(all[i].form->keyword.range))
        .related(all[0].at(all[0].form->keyword.range), "the first one");
}

} // namespace

void checkDuplicates(Context& context) {
  checkNames(context);
  checkConstantNames(context);
  checkEnvironments(context);
  checkPlatforms(context);
}

} // namespace proskill::analysis
