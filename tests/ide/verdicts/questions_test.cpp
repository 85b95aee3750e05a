#include "ide/verdicts/verification.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

struct Asked {
  std::string verdict; ///< with its reason
  std::string summary; ///< of its trace
};

Asked ask(const std::string& definitions, const std::string& pattern) {
  const auto program = test::programOfText(definitions + "(defproperty p " + pattern + ")");
  const auto model = codegen::generate(program, {}).value();
  const auto report = ide::verifyModel(model, {"p"}, {});
  REQUIRE(report.has_value());
  const auto& row = report->rows.at(0);
  Asked made{std::string(ide::toString(row.verdict)), row.trace ? row.trace->summary : ""};
  if (!row.reason.empty()) made.verdict += ", " + row.reason;
  return made;
}

/// The verdict on a property, with its reason.
std::string verdictOn(const std::string& pattern, bool fairRuns = true) {
  const auto program = test::programOfText("(defsv n :states (Idle Done) :init Idle)\n"
                                           "(defsv wind :states (Calm) :init Calm)\n"
                                           "(defevent gust :effects (wind Calm))\n"
                                           "(defskill drive :action (go))\n"
                                           "(defskill m :body ((drive) (set (n Done))))\n"
                                           "(defproperty p " +
                                           pattern + ")");
  const auto model = codegen::generate(program, {.fairRuns = fairRuns}).value();
  const auto report = ide::verifyModel(model, {"p"}, {});
  REQUIRE(report.has_value());
  const auto& row = report->rows.at(0);
  const auto verdict = std::string(ide::toString(row.verdict));
  return row.reason.empty() ? verdict : verdict + ", " + row.reason;
}

/// A skill of some duration, called once.
std::string driving(const std::string& interval) {
  return "(defsv n :states (Idle Done) :init Idle)\n"
         "(defskill drive " +
         interval +
         " :action (go))\n"
         "(defskill m :body ((^ 1) (drive) (set (n Done))))\n";
}

const std::string kDoor = "(defsv n :states (Idle Done) :init Idle)\n"
                          "(defsv door :states (Open Shut) :init Open)\n"
                          "(defevent shuts :every [5,5] :effects (door Shut))\n"
                          "(defskill m :body ((^ [1,10]) (if (door Open) (set (n Done)))))\n";

} // namespace

TEST_CASE("an unrelated event does not change what holds of all runs") {
  const std::string endless = "(defskill x :action (x)) (defskill m :body ((x)))";
  const std::string wind = "(defsv wind :states (Calm) :init Calm)"
                           "(defevent gust :effects (wind Calm))";
  for (const std::string property :
       {"(present (ended m) :fair nil)", "(leadsto (running x) (ended m) :fair nil)",
        "(ltl (<> (ended m)) :fair nil)", "(infinitelyoften (ended m) :fair nil)"}) {
    INFO(property);
    CHECK(ask(endless, property).verdict == "violated, of all runs, fair or not");
    CHECK(ask(endless + wind, property).verdict == "violated, of all runs, fair or not");
  }
  const std::string bounded = "(defskill x :time_interval [1,2] :action (x))"
                              "(defskill m :body ((x)))";
  CHECK(ask(bounded, "(present (ended m) :fair nil)").verdict == "holds, of all runs, fair or not");
}

TEST_CASE("what can always be reached is possible from everywhere") {
  const auto always = driving(":success there :failure stuck");
  CHECK(ask(always, "(always_reachable (n Done))").verdict == "holds");
  CHECK(ask(always, "(always_reachable (ended drive success))").verdict == "violated");
  CHECK(ask(always, "(always_reachable (n Idle))").verdict == "violated");
}

TEST_CASE("a trace leads to where it is too late") {
  const auto late = ask(kDoor, "(always_reachable (n Done))");
  CHECK(late.verdict == "violated");
  CHECK(late.summary == "After step 2, at 5 s, `(n Done)` can never become true any more.");
  CHECK(ask(kDoor, "(always_reachable (occurs shuts))").verdict == "holds");
}

TEST_CASE("the longest and the shortest time are exact") {
  const auto longest = [](const std::string& interval) {
    return ask(driving(interval), "(longest (running drive) (ended drive))").verdict;
  };
  const auto shortest = [](const std::string& interval) {
    return ask(driving(interval), "(shortest (running drive) (ended drive))").verdict;
  };
  CHECK(longest(":time_interval [2,5]") == "holds, at most 5 s");
  CHECK(longest(":time_interval [2,5[") == "holds, less than 5 s");
  CHECK(longest(":time_interval [0.25,7200.5]") == "holds, at most 7200.5 s");
  CHECK(longest("") == "holds, no upper bound");
  CHECK(shortest(":time_interval [2,5]") == "holds, at least 2 s");
  CHECK(shortest(":time_interval ]2,5]") == "holds, more than 2 s");
  CHECK(shortest("") == "holds, at least 0 s");
}

TEST_CASE("a time spans several steps, and may not exist") {
  const auto program = driving(":time_interval [2,5]");
  CHECK(ask(program, "(longest (called m) (n Done))").verdict == "holds, at most 6 s");
  CHECK(ask(program, "(shortest (called m) (n Done))").verdict == "holds, at least 3 s");
  CHECK(ask(program, "(longest (n Done) (running drive))").verdict == "holds, no upper bound");
  CHECK(ask(program, "(shortest (n Done) (running drive))").verdict ==
        "holds, `(running drive)` never follows `(n Done)`");
  CHECK(ask(program, "(longest (and (n Done) (running drive)) (n Idle))").verdict ==
        "holds, `(and (n Done) (running drive))` never becomes true");
}

TEST_CASE("where several initial values are possible, times begin after one is chosen") {
  const std::string program = "(defsv n :init (1 2) :min 1 :max 2)\n"
                              "(defsv wind :states (Calm) :init Calm)\n"
                              "(defevent gust :every [2,3] :effects (wind Calm))\n";
  CHECK(ask(program, "(longest (not (occurs gust)) true)").verdict == "holds, at most 0 s");
  CHECK(ask(program, "(shortest (not (occurs gust)) (occurs gust))").verdict ==
        "holds, at least 2 s");
  CHECK(ask(program, "(longest (n 1) (occurs gust))").verdict == "holds, at most 3 s");
}

TEST_CASE("a run shows the time that was asked for") {
  CHECK(ask(driving(":time_interval [2,5]"), "(longest (running drive) (n Done))").summary ==
        "A run with the longest time from `(running drive)` to `(n Done)`: at most 5 s.");
  CHECK(ask(driving(""), "(longest (running drive) (n Done))")
            .summary.ends_with(
                "`(n Done)` does not follow `(running drive)`: `m` waits for the end of `drive`."));
}

TEST_CASE("a property names the skills that end") {
  const std::string program =
      "(defskill a :action (a) :success done)\n(defskill b :action (b) :success done)\n"
      "(defskill m :success done :body ((// ((a)) ((b) (^ [1,...[))) (success done)))\n";
  const auto ends = [&](const std::string& skill, const std::string& fair) {
    return ask(program,
               "(leadsto (running " + skill + ") (not (running " + skill + ")) :fair " + fair + ")")
        .verdict;
  };
  CHECK(ends("a", "(a)") == "holds, unless `a` never ends");
  CHECK(ends("b", "(a)") == "violated");
  CHECK(ends("b", "(a b)") == "holds, unless `a` or `b` never ends");
  CHECK(ends("m", "(a b)") == "violated"); // its wait may last
  CHECK(ends("m", "(a b m)") == "holds, unless `a` or `b` or a wait of `m` never ends");
  CHECK(ends("m", "t") == ends("m", "(a b m)"));
}

TEST_CASE("a property says which runs without end count, whatever is asked for") {
  for (const std::string property : {"(present (n Done)", "(leadsto (n Idle) (n Done)",
                                     "(infinitelyoften (n Done)", "(ltl (<> (n Done))"}) {
    INFO(property);
    const std::string fair = "holds, unless `drive` never ends";
    const std::string all = "violated, of all runs, fair or not";
    CHECK(verdictOn(property + ")") == fair);
    CHECK(verdictOn(property + ")", false) == all);
    CHECK(verdictOn(property + " :fair t)", false) == fair);
    CHECK(verdictOn(property + " :fair nil)") == all);
  }
}

TEST_CASE("of what has a time limit no verdict speaks of fair runs") {
  CHECK(verdictOn("(present (n Done) :within [0,9])", false) == "violated");
  CHECK(verdictOn("(always (n Idle))", false) == "violated");
}
