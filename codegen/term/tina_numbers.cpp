#include "codegen/term/build.h"
#include "codegen/term/tina_edition.h"
#include "fiacre/check/typing.h"

#include <algorithm>
#include <optional>

namespace proskill::codegen {
namespace {

using fiacre::Expr;
using fiacre::ExprKind;
using fiacre::Op;
using fiacre::Statement;
using fiacre::StatementKind;
using fiacre::Type;
using fiacre::TypeKind;

bool isNumber(const Type& type) {
  return type.kind == TypeKind::Range || type.kind == TypeKind::Nat || type.kind == TypeKind::Int;
}

bool isComparison(const Expr& expr) {
  return expr.kind == ExprKind::Binary && expr.op >= Op::Equal && expr.op <= Op::GreaterEqual;
}

bool isArithmetic(const Expr& expr) {
  if (expr.kind == ExprKind::Unary) return expr.op == Op::Negate;
  return expr.kind == ExprKind::Binary && expr.op >= Op::Add && expr.op <= Op::Modulo;
}

bool isPlace(const Expr& expr) {
  return expr.kind == ExprKind::Name || expr.kind == ExprKind::Field ||
         expr.kind == ExprKind::Index;
}

/// Rewrites the expressions of one scope.
class Coercion {
public:
  Coercion(const fiacre::Declarations& known, fiacre::Scope names, const std::string& wide,
           bool& used)
      : known(known), names(std::move(names)), wide(wide), used(used) {}

  void rewrite(Statement& statement) {
    for (auto& value : statement.values) rewrite(value);
    if (statement.kind == StatementKind::Assign)
      for (std::size_t i = 0; i < statement.targets.size(); ++i)
        fit(statement.values[i], typeOf(statement.targets[i]));
    for (auto& child : statement.children) rewrite(child);
  }

  void rewrite(fiacre::Observable& observable) {
    if (observable.kind == fiacre::ObservableKind::Value) rewrite(observable.value);
    for (auto& operand : observable.operands) rewrite(operand);
  }

  /// Rewrites comparisons at any depth.
  void rewrite(Expr& expr) {
    if (!isComparison(expr)) {
      for (auto& operand : expr.operands) rewrite(operand);
      return;
    }
    const auto types = typesIn(expr);
    const bool computes = std::ranges::any_of(expr.operands, isArithmetic);
    if (!types.empty() && (computes || types.size() > 1))
      for (auto& operand : expr.operands) widen(operand);
  }

private:
  std::optional<Type> typeOf(const Expr& expr) {
    std::vector<fiacre::Problem> problems;
    auto type = fiacre::Typing(known, names, fiacre::Report(problems)).infer(expr);
    return type && isNumber(*type) ? type : std::nullopt;
  }

  /// The types of the variables and constants that are added or compared, without duplicates.
  std::vector<Type> typesIn(const Expr& expr) {
    std::vector<Type> all;
    if (isPlace(expr)) {
      if (auto type = typeOf(expr)) all.push_back(std::move(*type));
      return all;
    }
    if (!isArithmetic(expr) && !isComparison(expr)) return all;
    for (const auto& operand : expr.operands)
      for (auto& type : typesIn(operand))
        if (std::ranges::find(all, type) == all.end()) all.push_back(std::move(type));
    return all;
  }

  /// Whether `x + 1` stays within its type: the assignment is guarded by a test.
  bool stepsWithin(const Expr& expr, const Type& type) {
    return expr.kind == ExprKind::Binary && (expr.op == Op::Add || expr.op == Op::Subtract) &&
           isPlace(expr.operands[0]) && typeOf(expr.operands[0]) == type &&
           expr.operands[1].kind == ExprKind::Number;
  }

  /// Converts the value of an assignment to the variable's type.
  void fit(Expr& value, const std::optional<Type>& type) {
    if (!type) return;
    if (value.kind == ExprKind::Conditional) {
      fit(value.operands[1], type);
      fit(value.operands[2], type);
      return;
    }
    const bool fits = value.kind == ExprKind::Number || stepsWithin(value, *type) ||
                      (isPlace(value) && typeOf(value) == type);
    if (fits || !(isPlace(value) || isArithmetic(value))) return;
    if (isArithmetic(value)) widen(value);
    value = coerced(std::move(value));
  }

  static Expr coerced(Expr inner) {
    return {.kind = ExprKind::Unary, .op = Op::Coerce, .operands = {std::move(inner)}};
  }

  /// Makes it an `int`, by a function whose parameter determines the type that `$` converts to.
  void widen(Expr& expr) {
    if (isPlace(expr)) {
      if (!typeOf(expr)) return;
      used = true;
      expr = call(wide, {coerced(std::move(expr))});
    } else if (isArithmetic(expr)) {
      for (auto& operand : expr.operands) widen(operand);
    }
  }

  const fiacre::Declarations& known;
  fiacre::Scope names;
  const std::string& wide;
  bool& used;
};

fiacre::Scope scopeOf(const std::vector<fiacre::Parameter>& parameters,
                      const std::vector<fiacre::Variable>& variables) {
  fiacre::Scope scope;
  for (const auto& parameter : parameters)
    scope.emplace(parameter.name, fiacre::Symbol{parameter.type});
  for (const auto& variable : variables)
    scope.emplace(variable.name, fiacre::Symbol{variable.type});
  return scope;
}

bool isTaken(const fiacre::Program& program, const std::string& name) {
  const auto has = [&](const auto& all) {
    return std::ranges::any_of(all, [&](const auto& each) { return each.name == name; });
  };
  const auto binds = [&](const auto& all) {
    return std::ranges::any_of(
        all, [&](const auto& each) { return has(each.parameters) || has(each.variables); });
  };
  return has(program.constants) || has(program.types) || has(program.functions) ||
         has(program.processes) || has(program.components) || has(program.externs) ||
         has(program.tasks) || binds(program.functions) || binds(program.processes) ||
         binds(program.components);
}

fiacre::Function identity(const std::string& called) {
  fiacre::Function function;
  function.name = called;
  function.comment = "Converts a number to `int`.";
  function.parameters = {{"number", {.kind = TypeKind::Int}}};
  function.result = {.kind = TypeKind::Int};
  function.body = {.kind = StatementKind::Return, .values = {name("number")}};
  return function;
}

void rewriteProperties(fiacre::Program& program, Coercion& coercion) {
  for (auto& property : program.properties) {
    auto& pattern = property.pattern;
    for (auto& operand : pattern.operands) coercion.rewrite(operand);
    for (auto* scope : {&pattern.after, &pattern.before, &pattern.until})
      if (*scope) coercion.rewrite(**scope);
    const auto ltl = [&](auto& self, fiacre::Ltl& formula) -> void {
      coercion.rewrite(formula.atom);
      for (auto& operand : formula.operands) self(self, operand);
    };
    ltl(ltl, pattern.ltl);
  }
}

} // namespace

void coerceNumbers(fiacre::Program& program) {
  std::string wide = "integer";
  while (isTaken(program, wide)) wide += '_';
  bool used = false;
  const auto before = program; // for references of declarations
  const fiacre::Declarations known(before);
  for (auto& function : program.functions)
    Coercion(known, scopeOf(function.parameters, function.variables), wide, used)
        .rewrite(function.body);
  for (auto& process : program.processes) {
    Coercion coercion(known, scopeOf(process.parameters, process.variables), wide, used);
    for (auto& from : process.transitions) coercion.rewrite(from.statement);
  }
  for (const auto& component : before.components) {
    if (component.name != before.main) continue;
    Coercion coercion(known, scopeOf(component.parameters, component.variables), wide, used);
    rewriteProperties(program, coercion);
  }
  if (used) program.functions.insert(program.functions.begin(), identity(wide));
}

} // namespace proskill::codegen
