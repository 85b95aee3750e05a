#include "tests/support/models.h"

#include <catch2/catch.hpp>

using namespace proskill;
using namespace proskill::test;
using verify::Truth;

namespace {

/// Counters that count on their own: (size + 1)^count states.
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
