#include "fiacre/syntax/parse.h"
#include "verify/graph/state_graph.h"
#include "verify/limits.h"

#include <catch2/catch.hpp>

#include <set>

using namespace proskill;
using verify::Truth;

namespace {

std::string digits(std::size_t number) { return std::to_string(number); }

/// A process that goes through many states, in parallel with one that cycles. The questions are
/// about a state, a deadlock, whether time goes on, and whether one state leads to another.
fiacre::Parsed row(std::size_t length) {
  std::string text = "process Row is states s0";
  for (std::size_t i = 1; i <= length; ++i) text += ", s" + digits(i);
  text += " var x: 0.." + digits(length) + " := 0";
  for (std::size_t i = 0; i < length; ++i)
    text += " from s" + digits(i) + " wait [1,2]; x := " + digits(i) + "; to s" + digits(i + 1);
  text += "\nprocess Turn is states a, b from a wait [1,3]; to b from b wait [0,1]; to a\n"
          "component main is par * in Row || Turn end\n"
          "property reached is absent main/1/state s" +
          digits(length / 2) +
          "\nproperty free is deadlockfree\nproperty leads is main/2/state a leadsto main/2/state "
          "b\nproperty never is absent (main/1/state s0 and main/1/state s1)\nmain";
  return fiacre::parse(text);
}

const std::vector<verify::Question> kAll{{0}, {1}, {2}, {3}};

/// A clock that stands still until it is read for the n-th time, and is then past every limit.
class JumpingClock {
public:
  explicit JumpingClock(std::size_t when) : jump(when) {}
  [[nodiscard]] verify::Options options() {
    verify::Options made;
    made.limits.seconds = 10;
    made.clock = [this] { return ++looks > jump ? 1000.0 : 0.0; };
    return made;
  }
  std::size_t looks = 0;

private:
  std::size_t jump;
};

} // namespace

TEST_CASE("Whenever the time limit is met, what is decided is right and the rest names the limit") {
  const auto model = row(300);
  REQUIRE(model.problems.empty());
  const auto ask = [&](const verify::Options& options) {
    const auto result = verify::verify(model.program, model.provenance, kAll, options);
    REQUIRE(result.has_value());
    return *result;
  };
  JumpingClock never(SIZE_MAX);
  const auto whole = ask(never.options());
  REQUIRE(never.looks > 100); // each phase reads it
  std::size_t left = kAll.size();
  for (std::size_t when = 1; when < never.looks; when += 1 + never.looks / 97) {
    JumpingClock clock(when);
    const auto result = ask(clock.options());
    INFO("met at look " << when << " of " << never.looks);
    CHECK(clock.looks < when + 12); // nothing continues for long
    std::size_t open = 0;
    for (std::size_t i = 0; i < kAll.size(); ++i) {
      const auto& answer = result.answers[i];
      if (answer.truth != Truth::Unknown) {
        CHECK(answer.truth == whole.answers[i].truth);
        continue;
      }
      ++open;
      CHECK(answer.reason == "the time limit was reached");
    }
    CHECK(open <= left); // what is decided stays decided
    left = open;
  }
}

TEST_CASE("The time limit is met within a step of many clocks") {
  constexpr int kClocks = 120;
  std::string text = "process Step is states a, b from a wait [1,3]; to b from b wait [2,5]; to a\n"
                     "component main is par * in Step";
  for (int i = 1; i < kClocks; ++i) text += " || Step";
  const auto model = fiacre::parse(
      text + " end\nproperty far is absent (main/1/state b and main/2/state b)\nmain");
  REQUIRE(model.problems.empty());
  const auto ask = [&](JumpingClock& clock) {
    auto options = clock.options();
    options.limits.classes = 1;
    options.reductions.clear();
    const auto result = verify::verify(model.program, model.provenance, {{0}}, options);
    REQUIRE(result.has_value());
    return result->answers[0];
  };
  JumpingClock never(SIZE_MAX);
  CHECK(ask(never).reason == "the limit of classes was reached");
  REQUIRE(never.looks > 2 * kClocks); // for each clock of a zone
  for (std::size_t when = 1; when < never.looks; when += 1 + never.looks / 17) {
    JumpingClock clock(when);
    CHECK(ask(clock).reason == "the time limit was reached");
    CHECK(clock.looks < when + 12);
  }
}

TEST_CASE("A limit that is met before anything is explored leaves all open") {
  const auto model =
      fiacre::parse("process P is states a, b var v: array 20000 of 0..3 from a v[3] := 1; to b\n"
                    "component main is par * in P end\nproperty p is absent main/1/state a\nmain");
  REQUIRE(model.problems.empty());
  verify::Options options;
  std::string reason;
  SECTION("of time") {
    options.limits.seconds = 0;
    reason = "the time limit was reached";
  }
  SECTION("of memory, which is that of the process") {
    options.limits.bytes = 1;
    reason = "the memory limit was reached";
  }
  const auto result = verify::verify(model.program, model.provenance, {{0}}, options);
  REQUIRE(result.has_value());
  CHECK(result->answers[0].truth == Truth::Unknown);
  CHECK(result->answers[0].reason == reason);
  CHECK(result->exploration.classes == 0);
  CHECK_FALSE(result->exploration.complete);
  CHECK(result->exploration.stopped == reason);
  const auto graph = verify::stateGraph(model.program, verify::GraphKind::Classes, options);
  REQUIRE(graph.has_value());
  CHECK(graph->counts.stopped == reason);
  CHECK_FALSE(graph->counts.complete);
}

TEST_CASE("A verdict stands without its trace where the limit is met while that is made") {
  const auto model = row(600);
  REQUIRE(model.problems.empty());
  const auto ofTheWhole = [](verify::Options options) { // a slice's run counts once it is replayed
    options.reductions.erase(verify::Reduction::Slices);
    return options;
  };
  JumpingClock never(SIZE_MAX);
  const auto whole =
      verify::verify(model.program, model.provenance, {{0}}, ofTheWhole(never.options()));
  REQUIRE(whole.has_value());
  bool withoutTrace = false;
  for (std::size_t when = 1; when < never.looks; ++when) {
    JumpingClock clock(when);
    const auto result =
        verify::verify(model.program, model.provenance, {{0}}, ofTheWhole(clock.options()));
    REQUIRE(result.has_value());
    const auto& answer = result->answers[0];
    if (answer.truth != Truth::False || answer.trace) continue;
    withoutTrace = true;
    CHECK(answer.reason == "without a trace: the time limit was reached");
  }
  CHECK(withoutTrace);
}

TEST_CASE("What is decided is told as soon as it is, and once") {
  const auto model = row(40);
  REQUIRE(model.problems.empty());
  verify::Options options;
  std::vector<std::size_t> order;
  std::vector<Truth> truths(kAll.size(), Truth::Unknown);
  const auto whole = verify::verify(model.program, model.provenance, {{0}, {1}}, {});
  REQUIRE(whole.has_value());
  options.limits.classes = whole->exploration.classes * 3 / 4;
  options.decided = [&](std::size_t question, const verify::Answer& answer) {
    order.push_back(question);
    truths[question] = answer.truth;
    if (answer.truth == Truth::False) CHECK(answer.trace.has_value());
  };
  const auto result = verify::verify(model.program, model.provenance, kAll, options);
  REQUIRE(result.has_value());
  std::vector<Truth> answered;
  for (const auto& answer : result->answers) answered.push_back(answer.truth);
  CHECK(truths == answered);
  REQUIRE_FALSE(order.empty());
  CHECK(order.front() == 0); // it is reached long before the limit
  CHECK(std::set<std::size_t>(order.begin(), order.end()).size() == order.size());
  CHECK(order.size() < kAll.size());
}

TEST_CASE("The memory of a process is that which it uses") {
  const auto before = verify::residentBytes();
  if (before == 0) return; // the system does not report it
  std::vector<char> more(64 << 20, 1);
  CHECK(verify::residentBytes() >= before + (60 << 20) * static_cast<std::uint64_t>(more[5]));
}

TEST_CASE("A limit of memory is not met by what was freed before") {
  const auto before = verify::residentBytes();
  if (before == 0) return; // the system does not report it
  std::vector<std::vector<char>> pieces;
  for (int i = 0; i < 2000; ++i)
    pieces.emplace_back(50'000, 'x');         // too small to be mapped
                                              // separately
  const std::vector<char> above(50'000, 'x'); // keeps the heap from shrinking by itself
  pieces.clear();
  verify::Options options;
  options.limits.bytes = before + (64 << 20);
  const auto model = row(10);
  const auto result = verify::verify(model.program, model.provenance, {{0}}, options);
  REQUIRE(result.has_value());
  CHECK(result->answers[0].truth == Truth::False);
}
