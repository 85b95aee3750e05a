#include "codegen/model.h"
#include "fiacre/check/check.h"
#include "fiacre/print/print.h"
#include "tests/codegen/model_of.h"
#include "tests/support/random/random_constants.h"
#include "tests/support/random/random_program.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;
using codegen::Edition;
using codegen::StateVariableAutomata;

namespace {

constexpr std::uint64_t kPrograms = 2000;

std::string problemsOf(const codegen::Model& model) {
  std::string text;
  for (const auto& problem : fiacre::check(model.fiacre))
    text += problem.place + ": " + problem.message + "\n";
  return text;
}

/// Generates a model, and rejects one that a Fiacre compiler would reject.
codegen::Model modelOf(const std::string& text, const codegen::Options& options) {
  const auto program = test::programOfText(text);
  auto model = codegen::generate(program, options);
  INFO(text);
  if (!model) FAIL(model.error().message);
  CHECK(problemsOf(*model) == "");
  return std::move(*model);
}

void everyModelIsWellTyped(const codegen::Options& options) {
  for (std::uint64_t seed = 0; seed < kPrograms; ++seed)
    modelOf(test::textOf(test::randomProgram(seed, test::varied(seed))), options);
}

/// The inputs in a model that are truth values.
std::vector<std::string> truthsIn(const codegen::Model& model) {
  std::vector<std::string> names;
  for (const auto& component : model.fiacre.components)
    for (const auto& variable : component.variables)
      if (variable.type.kind == fiacre::TypeKind::Bool && variable.comment.contains("last call"))
        names.push_back(variable.name);
  return names;
}

bool isGiven(const std::string& model, const std::vector<std::string>& inputs,
             const std::vector<std::string>& values) {
  return std::ranges::any_of(inputs, [&](const auto& input) {
    return std::ranges::any_of(
        values, [&](const auto& value) { return model.contains(input + " := " + value + ";"); });
  });
}

} // namespace

TEST_CASE("random programs test truth values that calls pass, literals and their own inputs") {
  int literals = 0;
  int passed = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto model =
        modelOf(test::textOf(test::randomProgram(seed, {.composites = 2, .inputs = 60})), {});
    const auto inputs = truthsIn(model);
    const auto text = test::printed(model);
    literals += isGiven(text, inputs, {"true"}) && isGiven(text, inputs, {"false"}) ? 1 : 0;
    passed += isGiven(text, inputs, inputs) ? 1 : 0;
  }
  CHECK(literals > 20);
  CHECK(passed > 5);
}

TEST_CASE("no compact model of a random program is ill-typed or uses a reserved word") {
  everyModelIsWellTyped({});
}

TEST_CASE("no compact model with polling automata is ill-typed") {
  everyModelIsWellTyped({.automata = StateVariableAutomata::Paper});
}

TEST_CASE("no expanded model of a random program is ill-typed or uses a reserved word") {
  everyModelIsWellTyped({.edition = Edition::Expanded});
}

TEST_CASE("no runtime model of a random program is ill-typed or uses a reserved word") {
  everyModelIsWellTyped({.edition = Edition::Runtime});
}

TEST_CASE("a program gives the same model whenever it is translated") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto text = test::textOf(test::randomProgram(seed, test::varied(seed)));
    CHECK(fiacre::print(modelOf(text, {}).fiacre) == fiacre::print(modelOf(text, {}).fiacre));
  }
}

TEST_CASE(
    "the executed edition of random programs is well typed, with its environment and without") {
  everyModelIsWellTyped({.edition = Edition::Executed});
  everyModelIsWellTyped({.edition = Edition::Executed, .environment = true});
}

TEST_CASE("a random program with constants has the model of the program with their numbers") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto program = test::randomProgram(seed, {.properties = 4, .scopes = 40});
    const auto text = test::textOf(test::withConstants(program));
    INFO("seed " << seed << "\n" << text);
    CHECK(test::printed(test::modelOf(text)) ==
          test::printed(test::modelOf(test::textOf(program))));
  }
}

TEST_CASE("actions get the number as the constant has it") {
  const auto model = test::modelOf(R"((defconst home -0.50)
    (defskill go :input ($x float) :action (move $x home))
    (defskill mission :body ((go x home))))",
                                   {.edition = codegen::Edition::Executed});
  REQUIRE(model.actionCalls.size() == 1);
  CHECK(model.actionCalls[0].arguments == std::vector<std::string>{"-0.50", "-0.50"});
}
