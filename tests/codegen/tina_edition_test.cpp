#include "codegen/model.h"
#include "fiacre/check/check.h"
#include "fiacre/check/typing.h"
#include "fiacre/syntax/parse.h"
#include "tests/codegen/model_of.h"
#include "tests/support/random/random_program.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

using namespace proskill;
using Catch::Contains;
using codegen::Edition;
using fiacre::Expr;
using fiacre::ExprKind;
using fiacre::Op;
using fiacre::Type;
using fiacre::TypeKind;

namespace {

codegen::Model forTina(const std::string& text) {
  return test::modelOf(text, {.edition = Edition::Tina});
}

/// frac's rule: a number has exactly the type of its variable; literals and `$` have any type.
class StrictTypes {
public:
  explicit StrictTypes(const fiacre::Program& of) : program(of), known(of) {
    for (const auto& process : program.processes) {
      scope.clear();
      for (const auto& parameter : process.parameters)
        scope.emplace(parameter.name, fiacre::Symbol{parameter.type});
      for (const auto& variable : process.variables)
        scope.emplace(variable.name, fiacre::Symbol{variable.type});
      for (const auto& from : process.transitions) check(from.statement);
    }
  }

  std::string problems;

private:
  static bool isNumber(const Type& type) {
    return type.kind == TypeKind::Range || type.kind == TypeKind::Nat || type.kind == TypeKind::Int;
  }

  std::optional<Type> declared(const Expr& expr) {
    std::vector<fiacre::Problem> found;
    auto type = fiacre::Typing(known, scope, fiacre::Report(found)).infer(expr);
    return type && isNumber(*type) ? type : std::nullopt;
  }

  void unify(const std::optional<Type>& a, const std::optional<Type>& b, const std::string& where) {
    if (a && b && *a != *b) problems += where + "\n";
  }

  /// The type of a number; nullopt: any.
  std::optional<Type> typeOf(const Expr& expr) {
    if (expr.kind == ExprKind::Unary && expr.op == Op::Coerce) {
      typeOf(expr.operands[0]);
      return std::nullopt;
    }
    if (expr.kind == ExprKind::Number) return std::nullopt;
    if (expr.kind == ExprKind::Construct) {
      arguments(expr);
      return declared(expr);
    }
    if (expr.kind == ExprKind::Conditional) {
      typeOf(expr.operands[0]);
      return both(expr.operands[1], expr.operands[2]);
    }
    if (expr.kind != ExprKind::Binary) {
      for (const auto& operand : expr.operands) typeOf(operand);
      return declared(expr);
    }
    auto type = both(expr.operands[0], expr.operands[1]);
    return expr.op >= Op::Add && expr.op <= Op::Modulo ? type : std::nullopt;
  }

  void arguments(const Expr& call) {
    const auto found = known.functions.find(call.name);
    for (std::size_t i = 0; i < call.operands.size(); ++i) {
      const auto type = typeOf(call.operands[i]);
      if (found == known.functions.end()) continue;
      const auto wanted = fiacre::canonical(found->second->parameters.at(i).type, known);
      if (isNumber(wanted)) unify(type, wanted, call.name);
    }
  }

  std::optional<Type> both(const Expr& a, const Expr& b) {
    const auto left = typeOf(a);
    const auto right = typeOf(b);
    unify(left, right, "two types in one expression");
    return left ? left : right;
  }

  void check(const fiacre::Statement& statement) {
    for (std::size_t i = 0; i < statement.targets.size(); ++i)
      if (statement.kind == fiacre::StatementKind::Assign && declared(statement.targets[i]))
        unify(declared(statement.targets[i]), typeOf(statement.values[i]), "an assignment");
    for (const auto& value : statement.values) typeOf(value);
    for (const auto& child : statement.children) check(child);
  }

  const fiacre::Program& program;
  fiacre::Declarations known;
  fiacre::Scope scope;
};

const std::string kNumbers = R"(
  (defsv charge :min 0 :max 100 :init 50)
  (defsv load :min 0 :max 9 :init 1)
  (defsv floor :states (Low High) :init Low)
  (defevent sun :effects (charge (+ charge load)))
  (defskill lift :precondition (strong (> charge load)) :time_interval [1,2] :action (lift)
    :success (up (:effects ((floor High) (load charge)))))
  (defskill mission :body ((lift))))";

} // namespace

TEST_CASE("for Tina no process is without a `from`, and properties look at the right ones") {
  const auto expanded = test::modelOf(kNumbers, {.edition = codegen::Edition::Expanded});
  const auto model = forTina(kNumbers);
  for (const auto& process : model.fiacre.processes) CHECK_FALSE(process.transitions.empty());
  CHECK(model.fiacre.processes.size() == static_cast<std::size_t>(std::ranges::count_if(
                                             expanded.fiacre.processes, [](const auto& each) {
                                               return !each.transitions.empty();
                                             })));
  CHECK(model.fiacre.processes.size() < expanded.fiacre.processes.size());
  CHECK(fiacre::check(model.fiacre).empty());
}

TEST_CASE("for Tina a model of which nothing moves is still one that can be read") {
  const auto model = forTina("(defsv a :states (X Y) :init X) (defsv b :states (X Y) :init Y)");
  REQUIRE(model.fiacre.components[0].instances.size() == 1);
  const auto text = test::printed(model);
  CHECK_THAT(text, Contains("from legal\n    on false;\n    to legal"));
  CHECK(fiacre::parse(text).problems.empty());
  CHECK(fiacre::check(model.fiacre).empty());
}

TEST_CASE("for Tina numbers of different types meet as `int`, and are assigned by `$`") {
  const auto text = test::printed(forTina(kNumbers));
  CHECK_THAT(text, Contains("function integer (number: int): int is"));
  CHECK_THAT(text, Contains("integer($(charge)) > integer($(load))"));
  CHECK_THAT(test::printed(test::modelOf(kNumbers)), !Contains("$"));
}

TEST_CASE("no model for Tina of a random program mixes types or is ill-typed") {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const auto text = test::textOf(test::randomProgram(seed, test::varied(seed)));
    const auto model = codegen::generate(test::programOfText(text), {.edition = Edition::Tina});
    INFO("seed " << seed << "\n" << text);
    REQUIRE(model.has_value());
    CHECK(fiacre::check(model->fiacre).empty());
    CHECK(StrictTypes(model->fiacre).problems == "");
    for (const auto& process : model->fiacre.processes) CHECK_FALSE(process.transitions.empty());
  }
}

TEST_CASE("the check of types finds what the compact edition mixes") {
  CHECK(StrictTypes(test::modelOf(kNumbers).fiacre).problems != "");
}

TEST_CASE("a function of the program's own name is not taken for the coercion") {
  const auto text = test::printed(forTina(R"(
    (defsv integer :min 0 :max 9 :init 0)
    (defsv b :min 0 :max 5 :init 0)
    (defevent e :effects (integer (+ integer b)))
    (defskill s :action (s))
    (defskill mission :body ((s))))"));
  CHECK_THAT(text, Contains("integer_($(integer))"));
}
