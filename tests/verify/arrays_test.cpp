#include "fiacre/syntax/parse.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

#include <fmt/format.h>

using namespace proskill;
using verify::Truth;

namespace {

/// Asks whether each property of a model holds, in their order.
std::vector<verify::Answer> answersOf(const std::string& text) {
  const auto model = fiacre::parse(text);
  REQUIRE(model.problems.empty());
  std::vector<verify::Question> asked;
  for (std::size_t i = 0; i < model.program.properties.size(); ++i) asked.push_back({i});
  const auto result = verify::verify(model.program, model.provenance, asked, {});
  REQUIRE(result.has_value());
  return result->answers;
}

std::string arrayModel(std::size_t size, std::string_view variables, std::string_view steps,
                       std::string_view properties) {
  return fmt::format("process P is states a, b, good, bad\n"
                     "var v: array {0} of 0..3, i: 0..{1} := 0, x: 0..3 := 0{2}\n{3}\n"
                     "component main is par * in P end\n{4}\nmain",
                     size, size - 1, variables, steps, properties);
}

} // namespace

TEST_CASE("Each element of an array is read as it was written, however many there are") {
  const auto size = GENERATE(std::size_t{3}, std::size_t{65}, std::size_t{66}, std::size_t{300});
  const std::string last = std::to_string(size - 1);
  const auto answers = answersOf(
      arrayModel(size, "",
                 "from a v[i] := i % 4; if i = " + last +
                     " then i := 0; to b else i := i + 1; to a end\n"
                     "from b x := v[i]; if x <> i % 4 then to bad else if i = " +
                     last + " then to good else i := i + 1; to b end end",
                 "property p is absent main/1/state bad\nproperty q is absent main/1/state good"));
  REQUIRE(answers.size() == 2);
  CHECK(answers[0].truth == Truth::True);
  CHECK(answers[1].truth == Truth::False);
}

TEST_CASE("An index beyond a long array is an error") {
  const auto model = fiacre::parse(arrayModel(200, ", j: 0..300 := 200", "from a x := v[j]; to b",
                                              "property p is absent main/1/state b"));
  REQUIRE(model.problems.empty());
  const auto result = verify::verify(model.program, model.provenance, {{0}}, {});
  REQUIRE_FALSE(result.has_value());
  CHECK(result.error().message.ends_with("lies outside of 0..199"));
}

TEST_CASE("Of two targets that are the same element, the last one wins") {
  const auto answers =
      answersOf(arrayModel(100, ", j: 0..99 := 70", "from a i := 70; v[i], v[j] := 1, 2; to b",
                           "property p is absent main/1/value (v[70] = 1)\n"
                           "property q is absent main/1/value (v[70] = 2)"));
  REQUIRE(answers.size() == 2);
  CHECK(answers[0].truth == Truth::True);
  CHECK(answers[1].truth == Truth::False);
}

TEST_CASE("An array of a hundred thousand elements is read and written") {
  const auto answers = answersOf(arrayModel(
      100'000, "",
      "from a x := v[i]; v[(i + 1) % 100000] := (x + 1) % 4; i := (i + 1) % 100000; to a",
      "property p is absent main/1/value (x = 3)"));
  REQUIRE(answers.size() == 1);
  CHECK(answers[0].truth == Truth::False);
}
