#include "tests/support/result_text.h"

#include "fiacre/syntax/parse.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

#include <atomic>

namespace proskill::test::jobs_test {

namespace {

/// Philosophers at a round table; without time.
std::string philosophers(std::size_t count) {
  std::string text = R"(
process philosopher (&left: bool, &right: bool) is states thinking, one, eating, putting
from thinking on not left; left := true; to one
from one on not right; right := true; to eating
from eating left := false; to putting
from putting right := false; to thinking
component main is var)";
  for (std::size_t i = 0; i < count; ++i)
    text += (i == 0 ? " f" : ", f") + std::to_string(i) + ": bool := false";
  for (std::size_t i = 0; i < count; ++i)
    text += (i == 0 ? " par * in philosopher (&f" : " || philosopher (&f") + std::to_string(i) +
            ", &f" + std::to_string((i + 1) % count) + ")";
  return text + R"( end main
property neighbours is absent (main/1/state eating) and (main/2/state eating) assert neighbours
property others is absent (main/1/state eating) and (main/3/state eating) assert others
property alive is deadlockfree assert alive)";
}

/// Fischer's protocol, which fails if `look` is not greater than the longest write.
std::string fischer(std::size_t count, const std::string& look) {
  const std::string ids = std::to_string(count);
  std::string text = "process contender (me: 0.." + ids + ", &lock: 0.." + ids + R"() is
states idle, writing, looking, critical
from idle on lock = 0; to writing
from writing wait [0,2]; lock := me; to looking
from looking select wait )" +
                     look + R"(; on lock = me; to critical
[] on lock = 0; to writing end
from critical lock := 0; to idle
component main is var lock: 0..)" +
                     ids + " := 0 par * in";
  for (std::size_t i = 1; i <= count; ++i)
    text += (i == 1 ? " contender (" : " || contender (") + std::to_string(i) + ", &lock)";
  return text + R"( end main
property exclusive is absent (main/1/state critical) and (main/2/state critical) assert exclusive
property alive is deadlockfree assert alive
property reached is absent main/2/state critical assert reached)";
}

/// Processes with waits of different lengths: many zones for each state, some within others.
std::string waiters(std::size_t count) {
  std::string text = "process waiter (short: 0..9, &busy: 0..9) is states a, b, c "
                     "from a wait [1,3]; to b from b wait [2,5]; busy := short; to c "
                     "from c select wait [0,4]; on busy = short; to a [] wait [3,6]; to a end "
                     "component main is var busy: 0..9 := 0 par * in";
  for (std::size_t i = 1; i <= count; ++i)
    text += (i == 1 ? " waiter (" : " || waiter (") + std::to_string(i) + ", &busy)";
  return text + " end main "
                "property both is absent (main/1/state c) and (main/2/state c) assert both "
                "property alive is deadlockfree assert alive";
}

verify::Result results(const std::string& text, verify::Options options) {
  const auto parsed = fiacre::parse(text);
  REQUIRE(parsed.problems.empty());
  std::vector<verify::Question> questions;
  for (std::size_t i = 0; i < parsed.program.properties.size(); ++i) questions.push_back({i});
  auto result = verify::verify(parsed.program, parsed.provenance, questions, options);
  REQUIRE(result);
  return *std::move(result);
}

void checkJobs(const std::string& text, verify::Options options) {
  const auto alone = results(text, options);
  options.classesBeforeThreads = 20;
  options.nodesBeforeThreads = 1;
  for (const unsigned jobs : {2U, 4U, 8U}) {
    INFO(jobs << " threads");
    options.jobs = jobs;
    CHECK(textOf(alone) == textOf(results(text, options)));
  }
}

} // namespace

TEST_CASE("the number of threads changes neither verdicts nor counts nor traces") {
  for (const auto& text :
       {philosophers(8), fischer(5, "]2,...["), fischer(4, "[2,...["), waiters(3)})
    for (const bool isReduced : {true, false}) {
      verify::Options options;
      if (!isReduced)
        options.reductions = {verify::Reduction::Inclusion, verify::Reduction::Extrapolation};
      options.classesBeforeSlices = 300;
      checkJobs(text, options);
    }
  checkJobs(waiters(2), {.reductions = {verify::Reduction::Extrapolation}});
}

TEST_CASE("limits stop a search with several threads at the same class") {
  verify::Options options;
  options.limits.classes = 3000;
  const auto alone = results(philosophers(9), options);
  REQUIRE_FALSE(alone.exploration.complete);
  checkJobs(philosophers(9), options);
}

TEST_CASE("several threads can be cancelled, and notice a time limit") {
  const std::atomic<bool> cancelled{true};
  verify::Options options{.jobs = 3, .classesBeforeThreads = 0, .nodesBeforeThreads = 0};
  options.cancelled = &cancelled;
  CHECK(results(philosophers(12), options).exploration.stopped == "cancelled");
  options.cancelled = nullptr;
  options.limits.seconds = 0.2;
  options.reductions.erase(verify::Reduction::Refinement); // it answers at once
  const auto result = results(philosophers(16), options);
  CHECK(result.exploration.stopped == "the time limit was reached");
  CHECK(result.answers[0].truth == verify::Truth::Unknown);
}

} // namespace proskill::test::jobs_test
