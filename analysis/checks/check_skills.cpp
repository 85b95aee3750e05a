#include "analysis/checks/checks.h"

#include "analysis/names/arguments.h"
#include "analysis/names/expressions.h"

namespace proskill::analysis {

namespace {

void checkOutcomes(Expressions& expressions, const syntax::List<syntax::Outcome>& outcomes) {
  for (const syntax::Outcome& outcome : outcomes) {
    expressions.effects(outcome.effects);
    if (outcome.postcondition) expressions.condition(*outcome.postcondition);
  }
}

/// Checks everything but the body.
void checkSkill(Context& context, const Definition<syntax::Skill>& skill, SymbolId symbol) {
  Expressions expressions(context, skill.file, symbol);
  Names names(context, skill.file);
  for (const syntax::Input& input : skill->inputs) names.useType(input.type);
  for (const auto& precondition : skill->preconditions)
    expressions.condition(precondition.condition);
  expressions.effects(skill->start);
  for (const auto& invariant : skill->invariants) {
    expressions.condition(invariant.guard);
    expressions.effects(invariant.effects);
  }
  if (skill->interrupt) expressions.effects(skill->interrupt->effects);
  checkOutcomes(expressions, skill->successes);
  checkOutcomes(expressions, skill->failures);
  if (!skill->action) return;
  Arguments arguments(context, skill.file, symbol);
  for (const syntax::Expr& argument : skill->action->arguments) arguments.type(argument, {});
}

} // namespace

void checkSkills(Context& context) {
  context.each(SymbolKind::Skill, context.program.skills,
               [&](const auto& skill, SymbolId symbol) { checkSkill(context, skill, symbol); });
}

} // namespace proskill::analysis
