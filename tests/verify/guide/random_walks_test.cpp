#include "fiacre/syntax/parse.h"
#include "verify/guide/random_walks.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <set>

namespace proskill::test::random_walks_test {

namespace {

constexpr int kProcesses = 8;
constexpr int kSteps = 12;

/// Processes that take twelve steps each, never the same one twice in a row. The questions are
/// whether each gets to its end.
std::string model() {
  std::string text = "process P (me: nat, &last: 0..8) is states s0";
  for (int i = 1; i <= kSteps; ++i) text += fmt::format(", s{}", i);
  for (int i = 0; i < kSteps; ++i)
    text += fmt::format(" from s{} wait [1,3]; on last <> me; last := $(me); to s{}", i, i + 1);
  text += " from s12 wait [1,3]; on last <> me; last := $(me); loop";
  std::string instances;
  std::string questions;
  for (int i = 1; i <= kProcesses; ++i) {
    instances += fmt::format("{} P({}, &last)", i > 1 ? " ||" : "", i);
    questions += fmt::format(" property p{0} is absent main/{0}/state s12 assert p{0}", i);
  }
  return text + " component main is var last: 0..8 := 0 par * in" + instances + " end main" +
         questions;
}

/// The number of ends that are found.
std::size_t found(std::uint32_t classesOfLedSearches) {
  const auto parsed = fiacre::parse(model());
  REQUIRE(parsed.problems.empty());
  verify::Options options;
  options.classesBeforeSlices = 500;
  options.classesOfLedSearches = classesOfLedSearches;
  options.limits.classes = 6000;
  std::vector<verify::Question> questions;
  for (std::size_t i = 0; i < kProcesses; ++i) questions.push_back({i});
  const auto result = verify::verify(parsed.program, parsed.provenance, questions, options);
  REQUIRE(result);
  return static_cast<std::size_t>(
      std::ranges::count(result->answers, verify::Truth::False, &verify::Answer::truth));
}

} // namespace

TEST_CASE("a walk goes on from a successor, and begins anew where there is none") {
  verify::RandomWalks walks;
  walks.add(0);
  CHECK(walks.take() == 0);
  walks.add(1);
  walks.add(2);
  const auto first = walks.take();
  CHECK((first == 1 || first == 2));
  walks.add(3);
  CHECK(walks.take() == 3);
  CHECK(walks.take() == 3 - first);
}

TEST_CASE("every node is taken once, and in the same order each time") {
  std::vector<std::vector<std::uint32_t>> orders;
  for (int again = 0; again < 2; ++again) {
    verify::RandomWalks walks;
    auto& order = orders.emplace_back();
    walks.add(0);
    for (std::uint32_t added = 1; order.size() < 2000;) {
      order.push_back(walks.take());
      for (int i = 0; i < 2 && added < 2000; ++i) walks.add(added++);
    }
  }
  CHECK(std::set(orders[0].begin(), orders[0].end()).size() == 2000);
  CHECK(orders[0] == orders[1]);
}

TEST_CASE("random walks find what processes that run side by side reach late") {
  CHECK(found(0) == 0);
  CHECK(found(2000) == kProcesses);
}

} // namespace proskill::test::random_walks_test
