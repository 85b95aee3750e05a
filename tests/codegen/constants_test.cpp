#include "tests/codegen/model_of.h"
#include "tests/support/random/random_constants.h"
#include "tests/support/random/random_program.h"

#include <catch2/catch.hpp>

using namespace proskill;

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
