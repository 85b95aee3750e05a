#include "tests/viz/outline.h"

#include <catch2/catch.hpp>

namespace proskill::test::race_test {

using namespace proskill::viz;
using namespace proskill::viz::test;

namespace {

std::string drawn(const std::string& branches) {
  const auto p = program("(defsv s :states (X Y) :init X)\n(defskill a :action (a))\n"
                         "(defskill m :failure f :body ((race " +
                         branches + ")))");
  return outline(picture(p, Kind::Body, "m"));
}

} // namespace

TEST_CASE("the first branch of a race to come to its join goes on") {
  const auto race = drawn("((a)) ((^ 2) (if (s X) (failure f)))");
  CHECK(race.contains("a -> join: first"));
  CHECK(race.contains("(s X) -> join [no]: no, first"));
  CHECK_FALSE(race.contains("f -> join"));
}

} // namespace proskill::test::race_test
