#include "syntax/diagnostics/suggest.h"

#include <catch2/catch.hpp>

#include <initializer_list>

using namespace proskill;

namespace {

std::string_view best(std::string_view word, std::initializer_list<std::string_view> offered) {
  syntax::Suggestion suggestion(word);
  for (auto each : offered) suggestion.offer(each);
  return suggestion.best();
}

} // namespace

TEST_CASE("the nearest word is suggested, and of equals one with letters too few or too many") {
  CHECK(best("Of", {"On", "Off"}) == "Off");
  CHECK(best("Of", {"Off", "On"}) == "Off");
  CHECK(best("Opn", {"Own", "Open", "Opt"}) == "Open");
  CHECK(best("Oopen", {"Copen", "Open"}) == "Open");
  CHECK(best("redy", {"reddy", "ready"}) == "reddy"); // the first of equal ones
  CHECK(best("good", {"goods", "Good"}) == "Good");
  CHECK(best("takeof", {"take", "takeoff"}) == "takeoff");
  CHECK(best("x", {"y", "xy"}).empty());
  CHECK(best("lamp", {"door"}).empty());
}
