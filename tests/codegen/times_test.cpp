#include "tests/codegen/model_of.h"

#include <catch2/catch.hpp>

using namespace proskill;
using Catch::Contains;
using codegen::Edition;
using codegen::Options;
using syntax::Rational;

namespace {

std::string waiting(const std::string& duration) {
  return "(defskill mission :body ((^ " + duration + ")))";
}

const Options kRuntime{.edition = Edition::Runtime};

} // namespace

TEST_CASE("the unit is the largest that makes every bound an integer, a second at most") {
  CHECK(test::modelOf(waiting("2")).unit == Rational{1, 1});
  CHECK(test::modelOf(waiting("[60,120]")).unit == Rational{1, 1});
  CHECK(test::modelOf(waiting("[0.5,2]")).unit == Rational{1, 2});
  CHECK(test::modelOf(waiting("[0.2,0.25]")).unit == Rational{1, 20});
  CHECK(test::modelOf("(defresource rain)").unit == Rational{1, 1});
}

TEST_CASE("bounds of skills, of environments and of properties count too") {
  CHECK(test::modelOf(R"((defskill wave :time_interval [0.5,1] :action (wave))
                         (defskill mission :body ((wave)))
                         (defenvironment hall :body ((^ 0.2)))
                         (defproperty soon (leadsto (called wave) (running wave) :within [0,0.125])))")
            .unit == Rational{1, 40});
}

TEST_CASE("open bounds stay open") {
  CHECK_THAT(test::printedState(test::modelOf(waiting("]0.5,2[")), "skill_mission", "NS1"),
             Contains("wait ]1,4[;"));
  CHECK_THAT(test::printedState(test::modelOf(waiting("[1,...[")), "skill_mission", "NS1"),
             Contains("wait [1,...[;"));
}

TEST_CASE("a bound that has no place among the naturals is told with its place") {
  const auto text = waiting("[1,3000000000]");
  const auto error = test::errorOf(text);
  CHECK_THAT(error.message, Contains("3000000000 s is more than 2^31 of the model's units"));
  CHECK(text.substr(error.location.range.begin, error.location.range.length()) == "[1,3000000000]");
  CHECK_THAT(test::errorOf("(defskill m :body ((^ 0.000000001) (^ 4)))").message,
             Contains("4 s is more than 2^31"));
  CHECK_THAT(test::errorOf("(defskill m :body ((^ 0.00000000001)))").message,
             Contains("no common unit"));
}

TEST_CASE("at runtime bounds are ticks, and a wait lasts the first of its interval") {
  const auto wait = [](const std::string& duration) {
    return test::printedState(test::modelOf(waiting(duration), kRuntime), "skill_mission", "NS1");
  };
  CHECK(test::modelOf(waiting("2"), kRuntime).unit == Rational{1, 100});
  CHECK_THAT(wait("2"), Contains("wait [200,200];"));
  CHECK_THAT(wait("[1,3]"), Contains("wait [100,100];"));
  CHECK_THAT(wait("]1,3]"), Contains("wait [101,101];"));
  CHECK_THAT(wait("[1,...["), Contains("wait [100,100];"));
}

TEST_CASE("a bound that is no whole number of ticks is an error that names a rate") {
  CHECK_THAT(test::errorOf(waiting("0.125"), kRuntime).message,
             Contains("0.125 s is not a whole number of ticks at 100 Hz; it would be at 200 Hz"));
  CHECK_THAT(test::errorOf(waiting("]1,1.01["), kRuntime).message,
             Contains("no tick lies within this interval"));
  CHECK(
      test::modelOf(waiting("0.125"), {.edition = Edition::Runtime, .ticksPerSecond = 200}).unit ==
      Rational{1, 200});
}
