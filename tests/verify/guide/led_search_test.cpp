#include "fiacre/syntax/parse.h"
#include "verify/compile/compile.h"
#include "verify/guide/goal_distance.h"
#include "verify/state/run.h"
#include "verify/state/state_layout.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

namespace proskill::test::led_search_test {

namespace {

using verify::GoalDistance;

fiacre::Parsed parsed(const std::string& text, const std::string& condition) {
  auto made = fiacre::parse(text + "\nmain\nproperty p is absent " + condition + "\nassert p");
  REQUIRE(made.problems.empty());
  return made;
}

/// The estimate for the initial state.
std::uint32_t distanceOf(const std::string& text, const std::string& condition) {
  const auto model = parsed(text, condition);
  verify::LimitWatch limits{verify::Options{}};
  const auto compiled = verify::compile(model.program, model.provenance, {{0}}, &limits);
  REQUIRE(compiled);
  const auto laidOut = verify::withStateLayout(compiled->system);
  GoalDistance distance(compiled->system, laidOut, compiled->goals[0], {}, limits);
  return distance.from(verify::initialState(laidOut).data()).steps;
}

verify::Result answered(const std::string& text, const std::string& condition,
                        std::uint32_t classesOfLedSearches) {
  const auto model = parsed(text, condition);
  verify::Options options;
  options.classesBeforeSlices = 100;
  options.classesOfLedSearches = classesOfLedSearches;
  options.limits.classes = 3000;
  auto result = verify::verify(model.program, model.provenance, {{0}}, options);
  REQUIRE(result);
  return std::move(*result);
}

/// So many processes that each take five steps, or go back to the start.
std::string walkers(std::size_t count) {
  std::string text = "process P is states a, b, c, d, e, f ";
  for (const std::string step : {"ab", "bc", "cd", "de", "ef"})
    text += std::string("from ") + step[0] + " wait [1,3]; select to " + step[1] + " [] to a end ";
  text += "component main is par * in P";
  for (std::size_t i = 1; i < count; ++i) text += " || P";
  return text + " end";
}

std::string allAt(std::size_t count, const std::string& location) {
  std::string text = "(main/1/state " + location + ")";
  for (std::size_t i = 2; i <= count; ++i)
    text = "(" + text + " and (main/" + std::to_string(i) + "/state " + location + "))";
  return text;
}

} // namespace

TEST_CASE("the distance counts the steps to a state") {
  CHECK(distanceOf(walkers(1), "main/1/state c") == 2);
  CHECK(distanceOf(walkers(3), allAt(3, "c")) == 6);
}

TEST_CASE("the distance counts the steps that make conditions true") {
  const std::string processes = "process P (&ok: bool) is states a, b, c from a wait [0,1]; to b "
                                "from b if ok then to c else to a end "
                                "process Q (&ok: bool) is states s, t, u from s wait [1,1]; to t "
                                "from t ok := true; to u component main is ";
  CHECK(distanceOf(processes + "var ok: bool := true par * in P(&ok) || Q(&ok) end",
                   "main/1/state c") == 2);
  CHECK(distanceOf(processes + "var ok: bool := false par * in P(&ok) || Q(&ok) end",
                   "main/1/state c") == 4);
  CHECK(distanceOf(processes + "var ok: bool := false par * in P(&ok) end", "main/1/state c") ==
        GoalDistance::kFar);
}

TEST_CASE("a step that several parts of the goal need counts once in the distance") {
  // one step frees the place that both wait for
  const std::string text =
      "process Holder (&free: bool) is states a, b from a wait [1,1]; free := true; to b "
      "process Waiter (&free: bool) is states s, t "
      "from s wait [0,0]; on free; to t "
      "component main is var free: bool := false "
      "par * in Holder(&free) || Waiter(&free) || Waiter(&free) end";
  CHECK(distanceOf(text, "((main/2/state t) and (main/3/state t))") == 3);
}

TEST_CASE("a variable that counts has a distance for each value") {
  const std::string text =
      "process P (&n: 0..9) is states a from a wait [1,1]; on n < 9; n := n + 1; to a "
      "component main is var n: 0..9 := 2 par * in P(&n) end";
  const auto one = distanceOf(text, "main/value n = 3");
  CHECK(distanceOf(text, "main/value n = 7") == one + 4);
  CHECK(distanceOf(text, "main/value n = 1") == GoalDistance::kFar);
}

TEST_CASE("a led search finds what is reached late") {
  using verify::Truth;
  CHECK(answered(walkers(8), allAt(8, "f"), 0).answers[0].truth == Truth::Unknown);
  const auto found = answered(walkers(8), allAt(8, "f"), 2000);
  REQUIRE(found.answers[0].truth == Truth::False);
  CHECK(found.answers[0].trace->steps.size() == 40);
}

TEST_CASE("a led search concludes nothing from an estimate") {
  using verify::Truth;
  const std::string never = "process P is states a, b, c from a wait [1,3]; to b "
                            "from b wait [1,3]; to a component main is par * in P";
  std::string many = never;
  for (int i = 1; i < 12; ++i) many += " || P";
  CHECK(answered(many + " end",
                 "(main/1/state c and main/2/state a and main/3/state a and "
                 "main/4/state a and main/5/state a and main/6/state a and "
                 "main/7/state a and main/8/state a and main/9/state a and "
                 "main/10/state a and main/11/state a and main/12/state a)",
                 2000)
            .answers[0]
            .truth == Truth::Unknown);
}

} // namespace proskill::test::led_search_test
