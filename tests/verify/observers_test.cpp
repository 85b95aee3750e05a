#include "fiacre/syntax/parse.h"
#include "tests/support/text_model.h"
#include "verify/compile/compile.h"

#include <catch2/catch.hpp>

using namespace proskill;

using test::Text;

namespace {

/// A process of the model, and one that observes it through ports of the given types.
Text watched(const std::string& model, const std::string& ports, const std::string& observer) {
  return Text("process P [a: sync] is " + model +
              "\ncomponent main is port a: sync in [1,2] par * in P[a] end"
              "\nprocess W [p, q: sync] is " +
              observer + "\ncomponent watch is port " + ports +
              " par * in W[p, q] end\nwatch > main");
}

const std::string kThere = "states s, t, u from s wait [3,3]; to t from t wait [0,0]; to u";

} // namespace

TEST_CASE("a probe of a state is passed while it is there, before the model leaves it") {
  const auto model = watched(kThere, "p: sync in [0,0] is main/1/state t, q: sync in [5,5]",
                             "states w, seen from w p; to seen");
  CHECK(model.reaches("watch/1/state seen"));
  CHECK_FALSE(model.reaches("(main/1/state u) and (watch/1/state w)")); // never missed
  CHECK_FALSE(model.reaches("(main/1/state s) and (watch/1/state seen)"));
}

TEST_CASE("the time of a probe counts from when it holds and is waited for") {
  const std::string waits = "states w, seen from w p; to seen";
  const auto model = [&](const std::string& stay) {
    return watched("states s, t, u from s wait [3,3]; to t from t wait " + stay + "; to u",
                   "p: sync in [2,2] is main/1/state t, q: sync in [5,5]", waits);
  };
  CHECK_FALSE(model("[1,1]").reaches("watch/1/state seen"));
  CHECK(model("[3,3]").reaches("watch/1/state seen"));
  // at the very date at which the model may leave, the observer has priority
  CHECK_FALSE(model("[2,2]").reaches("(main/1/state u) and (watch/1/state w)"));
  CHECK(
      model("[3,3]").isTrue("(enter (main/1/state t)) leadsto (watch/1/state seen) within [2,2]"));
}

TEST_CASE("an observer goes before the model when its time has come, and not earlier") {
  const auto model = watched("states s, t from s a; to t", "p: sync in [1,1], q: sync",
                             "states w, late from w p; to late");
  CHECK_FALSE(model.reaches("(main/1/state t) and (watch/1/state w)"));
  const auto slow = watched("states s, t from s a; to t", "p: sync in [2,2], q: sync",
                            "states w, late from w p; to late");
  CHECK(slow.reaches("(main/1/state t) and (watch/1/state w)"));
}

TEST_CASE("a probe of an event is passed in the same step, and takes no time from the model") {
  const auto model = watched("states s, t from s a; to t", "p: sync is main/event a, q: sync",
                             "states w, seen from w p; to seen");
  CHECK_FALSE(model.reaches("(main/1/state t) and (watch/1/state w)"));
  CHECK_FALSE(model.reaches("(main/1/state s) and (watch/1/state seen)"));
  CHECK(model.isTrue("always ((main/event a) => (watch/event p))"));
  CHECK(model.trace("absent watch/1/state seen").steps.size() == 1);
  CHECK(model.isTrue("present (watch/1/state seen) within [1,2]"));
}

TEST_CASE("what an observer does not wait for happens all the same") {
  const auto model = watched("states s, t from s a; to t from t a; to s",
                             "p: sync is main/event a, q: sync in [10,10]",
                             "states w, seen, again from w p; to seen from seen q; to again");
  CHECK(model.reaches("(main/1/state s) and (watch/1/state seen)")); // it continues, unobserved
  CHECK(model.reaches("watch/1/state again"));
  CHECK(model.isTrue("always ((main/1/state t) => not (watch/1/state w))"));
}

TEST_CASE("an observer that becomes ready does not start the model's clocks anew") {
  const auto model = watched("states s, t from s wait [3,3]; #gone; to t",
                             "p: sync is main/1/tag gone, q: sync in [2,2]",
                             "states w, ready, seen from w q; to ready from ready p; to seen");
  CHECK(model.isTrue("present (main/1/state t) within [3,3]"));
  CHECK_FALSE(model.reaches("(main/1/state t) and (watch/1/state ready)"));
  const auto onPort =
      watched("states s, t from s a; to t", "p: sync is main/event a, q: sync in [1,1]",
              "states w, ready, seen from w q; to ready from ready p; to seen");
  CHECK(onPort.isTrue("present (main/1/state t) within [1,2]"));
}

TEST_CASE("probes of steps see what holds around them") {
  const std::string sees = "states w, seen from w p; to seen";
  const std::string twice = "states s, t var x: 0..2 := 0 from s a; x := x + 1; "
                            "if x = 2 then #second end; if x < 2 then to s else to t end";
  const auto model = [&](const std::string& probe) {
    return watched(twice, "p: sync is " + probe + ", q: sync in [9,9]", sees);
  };
  const std::string atOnce = "(main/1/value (x = 1)) and (watch/1/state seen)";
  CHECK(model("main/event a").reaches(atOnce));
  CHECK_FALSE(model("(main/event a) and (main/1/value (x = 1))").reaches(atOnce));
  CHECK(model("(main/event a) and (main/1/value (x = 1))").reaches("watch/1/state seen"));
  CHECK_FALSE(model("main/1/tag second").reaches(atOnce));
  CHECK(model("main/1/tag second").reaches("watch/1/state seen"));
  CHECK(model("enter (main/1/value (x = 1))").reaches(atOnce));
  CHECK_FALSE(model("leave (main/1/state s)").reaches(atOnce));
  CHECK(model("leave (main/1/state s)").reaches("watch/1/state seen"));
  CHECK(model("(not (main/1/tag second)) and (main/event a)").reaches(atOnce));
}

TEST_CASE("who can watch does, and one process watches one thing at a time") {
  const Text both("process P [a: sync] is states s, t from s a; to t\n"
                  "component main is port a: sync in [1,1] par * in P[a] end\n"
                  "process W [p: sync] is states w, seen from w p; to seen\n"
                  "component one is port p: sync is main/event a par * in W[p] end\n"
                  "component other is port p: sync is leave (main/1/state s) par * in W[p] end\n"
                  "one > main\nother > main");
  CHECK_FALSE(both.reaches("(one/1/state seen) and (other/1/state w)"));
  CHECK_FALSE(both.reaches("(one/1/state w) and (other/1/state seen)"));
  CHECK(both.reaches("(one/1/state seen) and (other/1/state seen)"));
  const auto choice = watched("states s, t from s a; to t",
                              "p: sync is main/event a, q: sync is leave (main/1/state s)",
                              "states w, x, y from w select p; to x [] q; to y end");
  CHECK(choice.reaches("watch/1/state x"));
  CHECK(choice.reaches("watch/1/state y"));
  CHECK_FALSE(choice.reaches("(main/1/state t) and (watch/1/state w)"));
}

TEST_CASE("formulas of runs see observers") {
  const auto model =
      watched("states s, t from s a; to t from t a; to s", "p: sync is main/event a, q: sync",
              "states even, odd from even p; to odd from odd p; to even");
  CHECK(model.isTrue("ltl [] ((main/1/state t) => (watch/1/state odd))"));
  CHECK(model.isTrue("ltl [] ((main/1/state s) => (watch/1/state even))"));
  CHECK(model.isFalse("ltl <> [] (watch/1/state odd)"));
}

TEST_CASE("a port of the model may have a probe, too") {
  const Text model("process P [a: sync] is states s, t from s a; to t\n"
                   "process Q is states u, v from u wait [4,4]; to v\n"
                   "component main is port a: sync in [1,1] is main/2/state v "
                   "par * in P[a] || Q end");
  CHECK(model.isTrue("present (main/1/state t) within [5,5]"));
}

TEST_CASE("compositions within compositions wait for each other as they say") {
  const std::string processes = "process P [a: sync] is states s, t from s a; to t\n";
  const auto model = [&](const std::string& composition) {
    return Text(processes + "component main is port a: sync in [1,1] " + composition);
  };
  const auto together = model("par * in par * in P[a] || P[a] end || P[a] end");
  CHECK_FALSE(together.reaches("(main/1/1/state t) and (main/2/state s)"));
  CHECK_FALSE(together.reaches("(main/1/1/state t) and (main/1/2/state s)"));
  CHECK(together.reaches("(main/1/1/state t) and (main/2/state t)"));
  const auto apart = model("par par * in P[a] || P[a] end || P[a] end");
  CHECK(apart.reaches("(main/1/1/state t) and (main/2/state s)"));
  CHECK_FALSE(apart.reaches("(main/1/1/state t) and (main/1/2/state s)"));
  const auto within = model("par * in par P[a] || P[a] end || P[a] end");
  CHECK(within.reaches("(main/1/1/state t) and (main/1/2/state s)"));
  CHECK_FALSE(within.reaches("(main/1/1/state t) and (main/2/state s)"));
}

TEST_CASE("a step that an observer cannot see has no variant with it") {
  const auto read =
      fiacre::parse("process P [a: sync, b: sync] is states s, t from s a; to t from t b; to s\n"
                    "component main is port a: sync, b: sync par * in P[a, b] end\n"
                    "process W [p: sync] is states w from w p; to w\n"
                    "component watch is port p: sync is main/event a par * in W[p] end\n"
                    "watch > main\nmain\n");
  REQUIRE(read.problems.empty());
  const auto compiled = verify::compile(read.program, {}, {});
  INFO((compiled ? "" : compiled.error().message));
  REQUIRE(compiled.has_value());
  CHECK(compiled->system.transitions.size() == 3); // a, b, and a that is seen
}
