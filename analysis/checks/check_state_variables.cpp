#include "analysis/checks/checks.h"

#include "analysis/names/expressions.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>

namespace proskill::analysis {

using syntax::Code;
using syntax::Expr;
using syntax::ExprKind;
using syntax::StateVariable;

namespace {

/// Limit of values. State variables are part of every state of the model, so with more values the
/// state space could not be explored.
constexpr std::int64_t kMostValues = 65536;

class StateVariables {
public:
  StateVariables(Context& context, const Definition<StateVariable>& variable, SymbolId symbol)
      : context(context), variable(variable), symbol(symbol), names(context, variable.file) {}

  void check() {
    if (variable->isNatural()) range();
    if (variable->states.empty() && !variable->isNatural()) return;
    init();
    for (const syntax::Transition& move : variable->transitions) {
      names.use(SymbolKind::Value, move.from, Role::Mention, symbol);
      names.use(SymbolKind::Value, move.to, Role::Mention, symbol);
    }
  }

private:
  void init() {
    init(variable->init);
    for (const Expr& other : variable->otherInits) init(other);
    for (const Expr& other : variable->otherInits) refuseRepeated(other);
  }

  /// Reports a value that occurs twice in `:init`.
  void refuseRepeated(const Expr& init) {
    for (const Expr* before = &variable->init; before != &init;
         before = before == &variable->init ? variable->otherInits.data() : before + 1) {
      const bool same = init.kind == before->kind &&
                        (init.kind == ExprKind::Symbol   ? init.name.text == before->name.text
                         : init.kind == ExprKind::Number ? init.number == before->number
                                                         : false);
      if (!same) continue;
      context.findings.report(Code::RepeatedInitial, at(init), textOf(init))
          .related(at(*before), "first listed here");
      return;
    }
  }

  void init(const Expr& init) {
    const Type wanted = context.typeOfVariable(symbol);
    if (init.kind == ExprKind::Missing) return;
    if (wanted.kind == TypeKind::Value && init.kind == ExprKind::Symbol)
      names.use(SymbolKind::Value, init.name, Role::Mention, symbol);
    else if (wanted.kind == TypeKind::Value && !isListed(init))
      context.findings.report(Code::InitialNotValue, at(init), variable.name());
    else if (wanted.kind != TypeKind::Value && isNatural(init))
      names.checkDomain(init, wanted);
  }

  /// Whether a truth value is among the values, which is reported there.
  [[nodiscard]] bool isListed(const Expr& init) const {
    return std::ranges::find(variable->states, textOf(init), &syntax::Name::text) !=
           variable->states.end();
  }

  void range() {
    const bool wellFormed = (!variable->min || isNatural(*variable->min)) &
                            (!variable->max || isNatural(*variable->max));
    if (!wellFormed || !variable->min || !variable->max) return;
    const auto least = variable->min->number.numerator, most = variable->max->number.numerator;
    if (least > most)
      context.findings.report(Code::EmptyRange, at(*variable->max), most, least)
          .related(at(*variable->min), "the least value");
    else if (most - least >= kMostValues)
      context.findings.report(Code::RangeTooLarge, at(*variable->max), variable.name(),
                              static_cast<std::uint64_t>(most - least) + 1, kMostValues);
  }

  /// Whether it is a natural; reports it otherwise.
  bool isNatural(const Expr& expr) {
    if (expr.kind == ExprKind::Symbol) {
      names.use(SymbolKind::Constant, expr.name, Role::Read);
      return false;
    }
    const bool natural =
        expr.kind == ExprKind::Number && typeOfNumber(expr).kind == TypeKind::Natural;
    if (!natural && expr.kind != ExprKind::Missing)
      context.findings.report(Code::ExpectedNatural, at(expr), describeLiteral(expr));
    return natural;
  }

  std::string describeLiteral(const Expr& expr) const {
    if (expr.kind == ExprKind::Number) return describe(typeOfNumber(expr), context.symbols);
    return "`" + textOf(expr) + "`";
  }

  [[nodiscard]] std::string textOf(const Expr& expr) const {
    return context.text(variable.file).substr(expr.range.begin, expr.range.length());
  }

  Location at(const Expr& expr) const { return variable.at(expr.range); }

  Context& context;
  const Definition<StateVariable>& variable;
  SymbolId symbol;
  Names names;
};

} // namespace

void checkStateVariables(Context& context) {
  context.each(SymbolKind::StateVariable, context.program.stateVariables,
               [&](const auto& variable, SymbolId symbol) {
                 StateVariables(context, variable, symbol).check();
               });
}

} // namespace proskill::analysis
