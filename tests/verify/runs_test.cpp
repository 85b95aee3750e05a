#include "tests/support/text_model.h"

#include <catch2/catch.hpp>

using namespace proskill;
using test::Text;

namespace {

/// Asked between 1 and 2, answered 2 to 3 later, quiet for 4.
const Text& dialogue() {
  static const Text model("process P is states quiet, asked, answered "
                          "from quiet wait [1,2]; #asks; to asked "
                          "from asked wait [2,3]; to answered "
                          "from answered wait [4,4]; to quiet\n"
                          "component main is par * in P end");
  return model;
}

/// It reaches `b` or not, as often as it likes.
const Text& chance() {
  static const Text model("process P is states a, b from a select to a [] to b end from b to a\n"
                          "component main is par * in P end");
  return model;
}

const std::string kAsks = "(enter (main/1/state asked))";
const std::string kAnswers = "(enter (main/1/state answered))";

} // namespace

TEST_CASE("`leadsto within` is about every time that the first is seen") {
  CHECK(dialogue().isTrue(kAsks + " leadsto " + kAnswers + " within [2,3]"));
  CHECK(dialogue().isFalse(kAsks + " leadsto " + kAnswers + " within [2,3["));
  CHECK(dialogue().isFalse(kAsks + " leadsto " + kAnswers + " within ]2,3]"));
  CHECK(dialogue().isTrue("(main/1/tag asks) leadsto (main/1/state answered) within [3,4]"));
  // At the beginning of the state the answer is too far, at its end near.
  CHECK(dialogue().isFalse("(main/1/state asked) leadsto " + kAnswers + " within [2,3]"));
  CHECK(dialogue().isTrue("(main/1/state asked) leadsto " + kAnswers + " within [0,3]"));
  CHECK(dialogue().isTrue("(main/1/state asked) leadsto (main/1/state answered)"));
}

TEST_CASE("`until` ends what waits for an open interval only before it begins") {
  CHECK(dialogue().isTrue(kAsks + " leadsto (not (main/1/tag asks)) after main/1/tag asks "
                                  "until main/1/state answered within ]0,4]"));
}

TEST_CASE("`leadsto first` does not let an early one pass") {
  CHECK(dialogue().isFalse("(main/1/tag asks) leadsto first (main/1/state asked) within [1,2]"));
  CHECK(dialogue().isTrue("(main/1/tag asks) leadsto (main/1/state asked) within [1,2]"));
}

TEST_CASE("a violation of time has a trace up to when it is too late") {
  const auto trace = dialogue().trace(kAsks + " leadsto " + kAnswers + " within [0,1]");
  REQUIRE(trace.steps.size() == 1);
  CHECK(trace.end > 2 * trace.scale); // asked at 1, and 1 has passed
  CHECK_FALSE(trace.loop.has_value());
}

TEST_CASE("`present` is about every run, and its violation is one that goes round") {
  CHECK(dialogue().isTrue("present main/1/state answered"));
  CHECK(dialogue().isTrue("present main/1/state answered within [3,5]"));
  CHECK(dialogue().isFalse("present main/1/state answered within [0,3]"));
  CHECK(chance().isFalse("present main/1/state b"));
  CHECK(chance().trace("present main/1/state b").loop == 0);
  CHECK(chance().reaches("main/1/state b"));
}

TEST_CASE("`lasting` is from the first time on") {
  CHECK(dialogue().isTrue("present main/1/state asked lasting 2"));
  CHECK(dialogue().isFalse("present main/1/state asked lasting 3"));
}

TEST_CASE("scopes: after the first time, before the first time") {
  CHECK(dialogue().isTrue("present main/1/state answered after main/1/state asked within [2,3]"));
  CHECK(dialogue().isFalse("present main/1/state answered after main/1/state asked within [0,2]"));
  CHECK(dialogue().isTrue("absent main/1/state answered after main/1/state asked within [0,2["));
  CHECK(dialogue().isFalse("absent main/1/state answered after main/1/state asked "
                           "for interval [0,2]"));
  CHECK(dialogue().isTrue("absent main/1/state answered before main/1/state asked"));
  CHECK(dialogue().isFalse("absent main/1/state quiet before main/1/state answered"));
  CHECK(dialogue().isTrue("absent main/1/state quiet before main/1/state answered for duration 2"));
  CHECK(
      dialogue().isFalse("absent main/1/state quiet before main/1/state answered for duration 3"));
  CHECK(dialogue().isTrue("present main/1/state asked before main/1/state answered within [2,3]"));
  CHECK(dialogue().isFalse("present main/1/state quiet before main/1/state answered within [2,3]"));
  CHECK(dialogue().isFalse("always not (main/1/state quiet) after main/1/state asked"));
  CHECK(chance().isTrue("absent main/1/state a before main/1/value false"));
}

TEST_CASE("scopes: from one to the next") {
  CHECK(dialogue().isTrue("absent main/1/state answered between main/1/state quiet and "
                          "main/1/state asked"));
  CHECK(dialogue().isFalse("absent main/1/state asked between main/1/state quiet and "
                           "main/1/state answered"));
  CHECK(dialogue().isTrue("present main/1/state asked after main/1/state quiet until "
                          "main/1/state answered"));
  CHECK(chance().isFalse("present main/1/state b after main/1/state a until main/1/value false"));
  CHECK(chance().isTrue("present main/1/state b between main/1/state a and main/1/value false"));
}

TEST_CASE("`precedes`, `infinitelyoften` and `mortal`") {
  CHECK(dialogue().isTrue("(main/1/state asked) precedes (main/1/state answered)"));
  CHECK(dialogue().isFalse("(main/1/state answered) precedes (main/1/state asked)"));
  CHECK(dialogue().isTrue("infinitelyoften main/1/state answered"));
  CHECK(chance().isFalse("infinitelyoften main/1/state b"));
  CHECK(dialogue().isFalse("mortal main/1/state answered"));
  const Text ends("process P is states a, b from a to b\ncomponent main is par * in P end");
  CHECK(ends.isTrue("mortal main/1/state a"));
  CHECK(ends.isTrue("infinitelyoften main/1/state b")); // the last state is for ever
}

TEST_CASE("a run that ends is judged by its last state, with what the question leaves out") {
  const Text ends("process P is states s0, s1 from s0 to s1\ncomponent main is par * in P end");
  CHECK(ends.isFalse("mortal main/1/state s1"));
  CHECK(ends.isFalse("infinitelyoften main/1/state s0"));
  CHECK(ends.trace("mortal main/1/state s1").steps.size() == 1);
  const Text beside("process P is states s0, s1 from s0 to s1\n"
                    "process Late is states a, b, c from a wait [2,...[; to b "
                    "from b wait [0,0]; to c\n"
                    "component main is par * in P || Late end");
  CHECK(beside.isFalse("mortal main/1/state s1"));
  CHECK(beside.isFalse("infinitelyoften main/1/state s0"));
  CHECK(beside.isFalse("present main/1/value false"));
}

TEST_CASE("LTL looks at states with the step that leaves them") {
  CHECK(dialogue().isTrue("ltl [] ((main/1/state asked) => <> (main/1/state answered))"));
  CHECK(dialogue().isTrue("ltl [] ((main/1/state quiet) => () (main/1/state asked))"));
  CHECK(dialogue().isTrue("ltl [] ((main/1/tag asks) => (main/1/state quiet))"));
  CHECK(dialogue().isTrue("ltl (not (main/1/state answered)) U (main/1/state asked)"));
  CHECK(dialogue().isFalse("ltl <> [] (not (main/1/state quiet))"));
  CHECK(chance().isFalse("ltl [] <> (main/1/state b)"));
  CHECK(chance().isTrue("ltl ([] <> (main/1/state b)) or (<> [] (main/1/state a))"));
  CHECK(chance().isFalse("ltl [] ((main/1/state a) => () (main/1/state b))"));
}

TEST_CASE("a violation of LTL has a trace with a stem and a loop") {
  const auto trace = chance().trace("ltl (<> (main/1/state b)) => ([] <> (main/1/state b))");
  REQUIRE(trace.loop.has_value());
  CHECK(*trace.loop >= 1);
  CHECK(*trace.loop < trace.steps.size());
}

TEST_CASE("times within the parts of a run count from their beginning, or from what asks") {
  const std::string part = " between (main/1/tag asks) and (enter (main/1/state quiet))";
  CHECK(dialogue().isTrue("present " + kAnswers + part + " within [2,3]"));
  CHECK(dialogue().isFalse("present " + kAnswers + part + " within [0,2]"));
  CHECK(dialogue().isTrue("absent " + kAnswers + part + " within [0,2["));
  CHECK(dialogue().isFalse("absent " + kAnswers + part + " within [0,2]"));
  CHECK(dialogue().isTrue("(main/1/tag asks) leadsto " + kAnswers + part + " within [2,3]"));
  const std::string last = " after (main/1/tag asks) until (main/1/value false)";
  CHECK(dialogue().isFalse("present (main/1/state quiet)" + last + " within ]0,5]"));
  CHECK(dialogue().isTrue("present (main/1/state quiet)" + last + " within [6,7]"));
}

TEST_CASE("`lasting` behind something counts from there on") {
  CHECK(dialogue().isTrue("present (main/1/state quiet) lasting 1 after (main/1/state answered)"));
  CHECK(dialogue().isFalse("present (main/1/state quiet) lasting 2 after (main/1/state answered)"));
}
