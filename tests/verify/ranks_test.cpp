#include "tests/support/random/random_model.h"
#include "tests/support/random/seeds.h"
#include "tests/support/thread_ranks.h"

#include "fiacre/print/print.h"
#include "verify/ranks/recently_sent.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <random>
#include <set>
#include <sstream>

namespace proskill::test::ranks_test {

namespace {

using verify::Reduction;
using Answered = std::expected<verify::Result, verify::Unsupported>;
using Ask = std::vector<verify::Question>;

/// The options of each rank.
using OptionsOf = std::function<verify::Options(unsigned)>;

Answered answersBy(unsigned ranks, const fiacre::Program& program, const Ask& questions,
                   const OptionsOf& optionsOf) {
  Answered result;
  ThreadRanks team(ranks, 1);
  team.run([&](verify::Ranks& rank) {
    verify::Options options = optionsOf(rank.self());
    options.ranks = &rank;
    auto answered = verify::verify(program, {}, questions, options);
    if (rank.self() == 0) result = std::move(answered);
  });
  return result;
}

std::string countsOf(const verify::Exploration& size) {
  std::ostringstream out;
  out << size.classes << " classes, " << size.markings << " markings, " << size.domains
      << " domains, " << size.transitions << " transitions, " << size.complete << size.stopped;
  return out.str();
}

/// Verdicts, and what a limit left open; a witness must have been replayed.
std::string verdictsOf(const verify::Result& result) {
  std::ostringstream out;
  for (const auto& answer : result.answers)
    out << static_cast<int>(answer.truth) << (answer.trace ? " with a trace " : " ")
        << answer.reason << '\n';
  return out.str();
}

/// Compares what several ranks answer with one another, and with one process that has none.
/// Where a limit ends the search of that process, it may have seen more or less by then.
/// \param isSameGraph whether that process counts the same, unless it ends before the graph does
void compare(const fiacre::Program& program, const Ask& questions, const verify::Options& options,
             bool isSameGraph) {
  const auto alone = verify::verify(program, {}, questions, options);
  const auto same = [&](unsigned) { return options; };
  const auto single = answersBy(1, program, questions, same);
  REQUIRE(alone.has_value() == single.has_value());
  if (!alone) return;
  const bool isLimited = alone->exploration.stopped == "the limit of classes was reached";
  if (!isLimited) CHECK(verdictsOf(*alone) == verdictsOf(*single));
  if (isSameGraph && alone->exploration.complete)
    CHECK(countsOf(alone->exploration) == countsOf(single->exploration));
  for (const unsigned ranks : {2U, 4U}) {
    INFO(ranks << " ranks");
    const auto shared = answersBy(ranks, program, questions, same);
    REQUIRE(shared);
    CHECK(verdictsOf(*single) == verdictsOf(*shared));
    CHECK(countsOf(single->exploration) == countsOf(shared->exploration));
  }
}

/// \param inTime whether to ask, too, whether time can stop, which may need a second search
Ask questionsOf(const fiacre::Program& program, bool inTime) {
  Ask questions;
  for (std::size_t i = 0; i < program.properties.size(); ++i)
    if (inTime || program.properties[i].pattern.kind != fiacre::PatternKind::Progress)
      questions.push_back({i});
  return questions;
}

/// All reductions but slices and refinement, so that the ranks share the search from its start.
std::set<Reduction> withoutParts() {
  auto reductions = verify::Options().reductions;
  reductions.erase(Reduction::Slices);
  reductions.erase(Reduction::Refinement);
  return reductions;
}

const std::set<Reduction> kSameGraph{Reduction::StubbornSets, Reduction::LiveVariables,
                                     Reduction::Extrapolation};

std::vector<fiacre::Program> randomModels(std::uint64_t seed) {
  return {randomModel(seed), randomModelWithData(seed), randomModelWithObserver(seed)};
}

} // namespace

TEST_CASE("several ranks agree with one, and with a process of its own") {
  const auto seeds = seedsOr(0, 12);
  constexpr std::uint64_t kMost = 2'000; // classes
  for (auto seed = seeds.first; seed < seeds.end; ++seed)
    for (const auto& program : randomModels(seed)) {
      INFO("seed " << seed << '\n' << fiacre::print(program));
      compare(program, questionsOf(program, true),
              {.reductions = withoutParts(), .limits = {.classes = kMost}}, false);
      compare(program, questionsOf(program, false),
              {.reductions = kSameGraph, .limits = {.classes = kMost}}, true);
    }
}

TEST_CASE("ranks share what is left when slices and led searches have done what they can") {
  for (const auto& program : randomModels(3)) {
    INFO(fiacre::print(program));
    compare(program, questionsOf(program, true),
            {.classesBeforeSlices = 3, .classesOfLedSearches = 50}, false);
  }
}

TEST_CASE("ranks stop at the same class, and a limit of one is a limit of all") {
  const auto program = randomModel(0);
  const auto questions = questionsOf(program, true);
  verify::Options options{.reductions = withoutParts(), .limits = {.classes = 40}};
  compare(program, questions, options, false);

  const std::atomic<bool> cancelled{true};
  const auto result = answersBy(3, program, questions, [&](unsigned rank) {
    return verify::Options{.reductions = withoutParts(),
                           .cancelled = rank == 2 ? &cancelled : nullptr};
  });
  REQUIRE(result);
  CHECK_FALSE(result->exploration.complete);
  CHECK(result->exploration.stopped == "cancelled");
}

TEST_CASE("ranks count the same state classes") {
  const verify::Options limited{.limits = {.classes = 100'000}};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto program = randomModel(seed);
    INFO("seed " << seed << '\n' << fiacre::print(program));
    const auto alone = verify::countClasses(program, limited);
    REQUIRE(alone);
    if (!alone->complete) continue;
    for (const unsigned ranks : {1U, 2U, 4U}) {
      std::string shared;
      ThreadRanks(ranks, seed).run([&](verify::Ranks& rank) {
        const auto counted = verify::countClasses(program, {.ranks = &rank});
        if (rank.self() == 0) shared = countsOf(counted.value());
      });
      CHECK(countsOf(*alone) == shared);
    }
  }
}

TEST_CASE("what is said to have been sent was sent") {
  std::mt19937 random(1);
  verify::RecentlySent recently(2);
  std::set<std::tuple<verify::Word, verify::Word, verify::ZoneId>> sent;
  std::size_t skipped = 0;
  for (int i = 0; i < 100'000; ++i) {
    const verify::Word state[2] = {random() % 300, random() % 300};
    const auto zone = static_cast<verify::ZoneId>(random() % 3);
    const bool isNew = sent.insert({state[0], state[1], zone}).second;
    const bool isSent = recently.note(state, zone);
    if (isNew) REQUIRE(isSent);
    if (!isSent) ++skipped;
    REQUIRE_FALSE(recently.note(state, zone));
  }
  CHECK(skipped > 0);
}

} // namespace proskill::test::ranks_test
