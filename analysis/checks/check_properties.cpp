#include "analysis/checks/checks.h"

#include "analysis/names/expressions.h"

namespace proskill::analysis {

void checkProperties(Context& context) {
  context.each(context.program.properties, [&](const auto& property) {
    Expressions expressions(context, property.file, kNoSymbol, Atoms::Property);
    for (const syntax::Expr& operand : property->operands) expressions.condition(operand);
    if (property->after) expressions.condition(*property->after);
    if (property->before) expressions.condition(*property->before);
    Names names(context, property.file);
    for (const syntax::Name& skill : property->fairSkills)
      names.use(SymbolKind::Skill, skill, Role::Read);
  });
}

} // namespace proskill::analysis
