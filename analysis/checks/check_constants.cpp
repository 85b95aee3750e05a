#include "analysis/checks/checks.h"
#include "syntax/diagnostics/codes.h"
#include "syntax/tree/parts.h"

namespace proskill::analysis {

using syntax::Code;
using syntax::Expr;
using syntax::Interval;
using syntax::Name;

namespace {

/// The constants of a definition: the uses of their names, and times that are negative.
class Constants {
public:
  Constants(Context& context, FileId file) : context(context), names(context, file), file(file) {}

  void operator()(const Expr& expr) {
    if (expr.kind == syntax::ExprKind::Number && expr.name) use(expr.name);
  }

  void operator()(const Interval& interval) {
    time(interval.lowerName);
    // The lone number of a wait is both bounds.
    if (interval.upperName.range != interval.lowerName.range) time(interval.upperName);
  }

  /// A number of seconds.
  void operator()(const syntax::Property& property) {
    if (!property.lasting) return;
    if (property.lasting->kind == syntax::ExprKind::Symbol)
      use(property.lasting->name);
    else
      checkTime(*property.lasting, property.lasting->range);
  }

private:
  SymbolId use(const Name& name) { return names.use(SymbolKind::Constant, name, Role::Read); }

  void time(const Name& name) {
    const SymbolId symbol = use(name);
    if (symbol == kNoSymbol) return;
    const auto& constant = context.program.constants.all[context.symbols[symbol].definition];
    checkTime(constant->value, name.range);
  }

  void checkTime(const Expr& number, syntax::Range at) {
    if (number.number < syntax::Rational{})
      context.findings.report(Code::NegativeTime, {file, at}, toString(number.number));
  }

  Context& context;
  Names names;
  FileId file;
};

} // namespace

void checkConstants(Context& context) {
  const auto check = [&](const auto& definition) {
    syntax::forEachPart(definition.node(), Constants(context, definition.file));
  };
  const Program& program = context.program;
  context.each(program.stateVariables, check);
  context.each(program.events, check);
  context.each(program.skills, check);
  context.each(program.resources, check);
  context.each(program.properties, check);
  context.each(program.environments, check);
}

} // namespace proskill::analysis
