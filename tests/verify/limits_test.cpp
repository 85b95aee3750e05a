#include "fiacre/syntax/parse.h"
#include "tests/support/models.h"
#include "tests/support/text_model.h"
#include "verify/graph/state_graph.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace proskill;
using namespace proskill::test;
using verify::Truth;

namespace {

/// Independent counters: (size + 1)^count states.
Model counters(int count, int size) {
  Model model;
  for (int i = 0; i < count; ++i) {
    const std::string text = "x" + std::to_string(i);
    fiacre::Process counter =
        process("p" + std::to_string(i), {"a"},
                {from("a", {on(binary(fiacre::Op::Less, name(text), number(size))),
                            assign(name(text), sum(name(text), number(1))), to("a")})});
    counter.variables.push_back({text, range(0, size), number(0), {}});
    model.add(std::move(counter));
  }
  return model;
}

} // namespace

TEST_CASE("An exploration without a limit is complete, and counts") {
  auto model = counters(3, 4);
  model.ask(plain(fiacre::PatternKind::Progress));
  auto result = model.answers();
  CHECK(result.exploration.complete);
  CHECK(result.exploration.stopped.empty());
  CHECK(result.exploration.markings == 125);
  CHECK(result.exploration.classes == 125);
  CHECK(result.exploration.transitions == 3 * 4 * 25);
  CHECK(result.exploration.bytes > 0);
}

TEST_CASE("A limit leaves open what is not decided, and keeps what is") {
  auto model = counters(4, 30);
  model.ask(absentState(1, "a")).ask(plain(fiacre::PatternKind::DeadlockFree));
  verify::Options options;
  SECTION("of classes") { options.limits.classes = 5000; }
  SECTION("of memory") { options.limits.bytes = 1 << 20; }
  SECTION("of time") { options.limits.seconds = 0; }
  auto result = model.answers(options);
  CHECK(result.answers[0].truth == Truth::False);
  CHECK(result.answers[1].truth == Truth::Unknown);
  CHECK_FALSE(result.answers[1].reason.empty());
  CHECK_FALSE(result.exploration.complete);
  CHECK(result.exploration.bytes < 8 << 20);
}

TEST_CASE("An exploration can be cancelled") {
  auto model = counters(4, 30);
  std::atomic<bool> cancelled = true;
  verify::Options options;
  options.cancelled = &cancelled;
  auto answer = model.answer(plain(fiacre::PatternKind::DeadlockFree), options);
  CHECK(answer.truth == Truth::Unknown);
  CHECK(answer.reason == "cancelled");
}

TEST_CASE("An exploration stops, and says so, when all questions are decided") {
  auto model = counters(4, 30);
  model.ask(absentState(1, "a"));
  auto result = model.answers();
  CHECK(result.answers[0].truth == Truth::False);
  CHECK_FALSE(result.exploration.complete);
  CHECK(result.exploration.stopped == "all questions decided");
}

TEST_CASE("The class graph stops at a limit, too") {
  verify::Options options;
  options.limits.classes = 1000;
  auto counted = verify::countClasses(counters(4, 30).program(), options);
  REQUIRE(counted.has_value());
  CHECK_FALSE(counted->complete);
  CHECK(counted->classes >= 1000);
}

TEST_CASE("What the engine does not run is said, with its place") {
  Model model;
  fiacre::Statement start{.kind = fiacre::StatementKind::Start, .origin = 5, .name = "task"};
  model.add(process("p", {"a"}, {from("a", {start, to("a")})}));
  model.ask(absentState(1, "a"));
  auto result = verify::verify(model.program(), {}, {{0}});
  REQUIRE_FALSE(result.has_value());
  CHECK(result.error().origin == 5);
}

TEST_CASE("Patterns without a meaning are answered with unknown, and the reason") {
  auto asked = absentState(1, "a");
  asked.pattern.kind = fiacre::PatternKind::Mortal;
  asked.pattern.within = fiacre::Interval{.lower = 0, .upper = 1};
  auto answer = counters(1, 1).answer(asked);
  CHECK(answer.truth == Truth::Unknown);
  CHECK_THAT(answer.reason, Catch::Contains("has no meaning"));
}

namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

} // namespace

TEST_CASE("What would be too large is refused before it is built") {
  const auto process = [](const std::string& choices) {
    return test::processText("states a, b var x: 0..3 from a " + choices + "to b").refusal();
  };
  CHECK_THAT(process(repeated("select x := 0 [] x := 1 end; ", 40)),
             Catch::Contains("more than 10000 paths"));
  CHECK_THAT(process(repeated("if x = 0 then x := 1 else if x = 1 then to b end end; ", 30)),
             Catch::Contains("too many choices"));
  std::string sends = "p ! 0; to b";
  for (const char* value : {"1", "2", "3"}) sends += std::string(" [] p ! ") + value + "; to b";
  const test::Text senders("process S [p: out 0..3] is states a, b from a select " + sends +
                           " end\ncomponent main is port p: 0..3 par * in S[p]" +
                           repeated(" || S[p]", 9) + " end");
  CHECK_THAT(senders.refusal(), Catch::Contains("too many synchronisations on `p`"));
}

TEST_CASE("Priorities that go round are refused, through components as well") {
  const test::Text model("process P [p, q: sync] is states a from a select p; to a [] q; to a end\n"
                         "component inner [p, q: sync] is priority q > p par * in P[p, q] end\n"
                         "component main is port p, q: sync priority p > q "
                         "par * in inner[p, q] end");
  CHECK_THAT(model.refusal(), Catch::Contains("has priority over itself"));
}

TEST_CASE("Five operators that expect each other are not too large a formula") {
  const auto holds = [](int value) { return fmt::format("(main/1/value (x = {}))", value); };
  const auto weak = [](const std::string& a, const std::string& b) {
    return fmt::format("((({0}) U ({1})) or ([] ({0})))", a, b);
  };
  const auto strong = [](const std::string& a, const std::string& b) {
    return fmt::format("(({1}) U (({0}) and ({1})))", a, b);
  };
  const auto formula =
      strong(strong(holds(0), weak(holds(1), holds(2))), weak(weak(holds(3), holds(1)), holds(1)));
  const Text model("process P is states a var x: 0..3 := 1 from a x := 3; to a "
                   "component main is par * in P end");
  CHECK(model.isFalse("ltl " + formula));
}

TEST_CASE("A formula of LTL that is too large leaves its own question open, and no other") {
  std::string fair = "main/1/value (x = 1)";
  for (int i = 0; i < 14; ++i)
    fair = "([] <> (main/1/value (x = " + std::to_string(i % 4) + " and y = " + std::to_string(i) +
           "))) and (" + fair + ")";
  const auto read = fiacre::parse("process P is states a, b var x: 0..3, y: 0..20 from a to b\n"
                                  "component main is par * in P end\n"
                                  "property large is ltl not (" +
                                  fair + ") property small is absent main/1/state b\nmain");
  REQUIRE(read.problems.empty());
  const auto result = verify::verify(read.program, read.provenance, {{0}, {1}}, {});
  REQUIRE(result.has_value());
  CHECK(result->answers[0].truth == Truth::Unknown);
  CHECK_THAT(result->answers[0].reason, Catch::Contains("too large"));
  CHECK(result->answers[1].truth == Truth::False);
}

TEST_CASE(
    "There are no state classes where what goes first has to wait; without time it goes first") {
  const auto read = fiacre::parse("process P [p, q: sync] is states a, b, c "
                                  "from a select p; to b [] q; to c end\n"
                                  "component main is port p: sync in [2,3], q: sync in [0,4] "
                                  "priority p > q par * in P[p, q] end\nmain");
  REQUIRE(read.problems.empty());
  for (auto kind : {verify::GraphKind::Classes, verify::GraphKind::Markings}) {
    const auto graph = verify::stateGraph(read.program, kind, {});
    REQUIRE_FALSE(graph.has_value());
    CHECK_THAT(graph.error().message, Catch::Contains("--graph-of untimed"));
  }
  CHECK_FALSE(verify::countClasses(read.program, {}).has_value());
  const auto untimed = verify::stateGraph(read.program, verify::GraphKind::Untimed, {});
  REQUIRE(untimed.has_value());
  CHECK(untimed->counts.markings == 2); // a, and b by p
}

TEST_CASE("A run that never comes to something is found in a part of what can be reached") {
  const auto turns = [](const std::string& name, int last) {
    const auto most = std::to_string(last);
    return "process " + name + " is states a var x: 0.." + most + " := 0 from a if x < " + most +
           " then x := x + 1 else x := 0 end; to a\n";
  };
  const auto read = fiacre::parse(turns("Ten", 9) + turns("Three", 2) +
                                  "component main is par * in Ten" + repeated(" || Three", 10) +
                                  " end\nproperty five is ltl <> (main/1/value (x = 5))\n"
                                  "assert five\nmain");
  REQUIRE(read.problems.empty());
  verify::Options options;
  options.limits.classes = 20'000; // of 590,490
  const auto result = verify::verify(read.program, read.provenance, {{0}}, options);
  REQUIRE(result.has_value());
  CHECK(result->answers[0].truth == Truth::False);
}
