#include "tests/viz/outline.h"

#include <catch2/catch.hpp>

namespace proskill::test::monitors_test {

using namespace proskill::viz;
using namespace proskill::viz::test;

namespace {

/// A monitor with a precondition; `monitor` is the value of its field.
std::string drawn(const std::string& monitor) {
  const auto p = program("(defsv s :states (X Y) :init X)\n(defskill a :action (a))\n"
                         "(defskill w :precondition (x (s X)) :monitor " +
                         monitor + " :body ((a)))");
  return outline(picture(p, Kind::Body, "w"));
}

} // namespace

TEST_CASE("a monitor is refused where its precondition is false at the start") {
  CHECK(drawn("t").contains("-> refused [no]: no"));
}

TEST_CASE("a monitor that is always armed waits for its precondition and is not refused") {
  const auto armed = drawn("always");
  CHECK(armed.contains("wait until the precondition holds {x: (s X)}"));
  CHECK_FALSE(armed.contains("refused"));
  CHECK(armed.contains("-> until the precondition holds: once it is false"));
  CHECK_FALSE(drawn("t").contains("once it is false"));
}

} // namespace proskill::test::monitors_test
