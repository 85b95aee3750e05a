#include "tests/support/random/random_model.h"
#include "tests/support/random/seeds.h"
#include "tests/support/result_text.h"
#include "tests/support/spill_in_memory.h"

#include "fiacre/print/print.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <set>
#include <sstream>

namespace proskill::test::spill_test {

namespace {

using verify::Reduction;
using Ask = std::vector<verify::Question>;

constexpr std::uint64_t kMost = 3'000; ///< classes

Ask allOf(const fiacre::Program& program) {
  Ask questions;
  for (std::size_t i = 0; i < program.properties.size(); ++i) questions.push_back({i});
  return questions;
}

/// The answers with the graph on disk, where tables have so few bytes that everything is there.
verify::Result answersOnDisk(const fiacre::Program& program, const Ask& questions,
                             verify::Options options, std::uint64_t bytes) {
  SpillInMemory disk;
  options.spill = &disk;
  options.spillBytes = bytes;
  auto answered = verify::verify(program, {}, questions, options);
  REQUIRE(answered.has_value());
  CHECK(disk.files == 0);
  return std::move(*answered);
}

/// Verdicts, and what a limit left open; a witness must have been replayed.
std::string verdictsOf(const verify::Result& result) {
  std::ostringstream out;
  for (const auto& answer : result.answers)
    out << static_cast<int>(answer.truth) << (answer.trace ? " with a trace " : " ")
        << answer.reason << '\n';
  return out.str();
}

std::string countsOf(const verify::Exploration& size) {
  std::ostringstream out;
  out << size.classes << " classes, " << size.markings << " markings, " << size.domains
      << " domains, " << size.transitions << " transitions, " << size.complete << size.stopped;
  return out.str();
}

std::set<Reduction> without(const std::vector<Reduction>& some) {
  auto reductions = verify::Options().reductions;
  for (const auto reduction : some) reductions.erase(reduction);
  return reductions;
}

std::vector<fiacre::Program> randomModels(std::uint64_t seed) {
  return {randomModel(seed), randomModelWithData(seed), randomModelWithObserver(seed)};
}

} // namespace

TEST_CASE(
    "without inclusion a search on disk gives the verdicts, counts and traces of one in memory") {
  const auto seeds = seedsOr(0, 40);
  const std::vector<std::set<Reduction>> settings{
      without({Reduction::Slices, Reduction::Refinement, Reduction::Inclusion}),
      {Reduction::StubbornSets, Reduction::LiveVariables, Reduction::Extrapolation},
      {Reduction::FreeInputs}};
  std::uint64_t compared = 0;
  for (auto seed = seeds.first; seed < seeds.end; ++seed)
    for (const auto& program : randomModels(seed)) {
      INFO("seed " << seed << '\n' << fiacre::print(program));
      const verify::Options options{.reductions = settings[seed % settings.size()],
                                    .limits = {.classes = kMost}};
      const auto questions = allOf(program);
      const auto inMemory = verify::verify(program, {}, questions, options);
      REQUIRE(inMemory.has_value());
      if (inMemory->exploration.stopped == "the limit of classes was reached") continue;
      ++compared;
      for (const std::uint64_t bytes : {1U, 3000U, 100'000U})
        REQUIRE(textOf(answersOnDisk(program, questions, options, bytes)) == textOf(*inMemory));
    }
  CHECK(compared > seeds.end - seeds.first);
}

TEST_CASE(
    "with inclusion a search on disk gives the verdicts of one in memory, whatever its memory") {
  const auto seeds = seedsOr(0, 40);
  for (auto seed = seeds.first; seed < seeds.end; ++seed)
    for (const auto& program : randomModels(seed)) {
      INFO("seed " << seed << '\n' << fiacre::print(program));
      const verify::Options options{.reductions =
                                        without({Reduction::Slices, Reduction::Refinement}),
                                    .limits = {.classes = kMost}};
      const auto questions = allOf(program);
      const auto inMemory = verify::verify(program, {}, questions, options);
      REQUIRE(inMemory.has_value());
      if (inMemory->exploration.stopped == "the limit of classes was reached") continue;
      const auto tiny = answersOnDisk(program, questions, options, 1);
      REQUIRE(verdictsOf(tiny) == verdictsOf(*inMemory));
      REQUIRE(textOf(answersOnDisk(program, questions, options, 5000)) == textOf(tiny));
    }
}

TEST_CASE("a count on disk is the one in memory") {
  const auto seeds = seedsOr(0, 40);
  std::uint64_t classes = 0;
  for (auto seed = seeds.first; seed < seeds.end; ++seed) {
    const auto program = randomModel(seed);
    INFO("seed " << seed << '\n' << fiacre::print(program));
    const auto inMemory = verify::countClasses(program, {.limits = {.classes = 20'000}});
    REQUIRE(inMemory.has_value());
    if (!inMemory->complete) continue;
    for (const std::uint64_t bytes : {1U, 5000U, 1'000'000U}) {
      SpillInMemory disk;
      const auto onDisk = verify::countClasses(program, {.spill = &disk, .spillBytes = bytes});
      REQUIRE(onDisk.has_value());
      CHECK(countsOf(*onDisk) == countsOf(*inMemory));
      CHECK((disk.written > 0 || bytes > 1 || onDisk->classes < 100));
    }
    classes += inMemory->classes;
  }
  CHECK(classes > 100 * (seeds.end - seeds.first));
}

TEST_CASE("a disk that fails at any moment leaves open what is not decided, and says why") {
  const auto program = randomModelWithData(1);
  const auto questions = allOf(program);
  verify::Options options{.reductions = without({Reduction::Slices, Reduction::Refinement}),
                          .spillBytes = 1};
  SpillInMemory disk;
  options.spill = &disk;
  const auto whole = verify::verify(program, {}, questions, options);
  REQUIRE(whole.has_value());
  const auto operations = disk.operations;
  REQUIRE(operations > 200);
  std::size_t open = 0;
  for (std::uint64_t failing = 0; failing < operations; failing += 1 + operations / 150) {
    INFO("operation " << failing);
    SpillInMemory full;
    full.problem = [&](std::uint64_t now) { return now >= failing ? "it is full" : ""; };
    options.spill = &full;
    const auto limited = verify::verify(program, {}, questions, options);
    REQUIRE(limited.has_value());
    CHECK(full.files == 0);
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const auto& answer = limited->answers[i];
      if (answer.truth == verify::Truth::Unknown) {
        ++open;
        CHECK((answer.reason == "it is full" || answer.reason == whole->answers[i].reason));
      } else {
        CHECK(answer.truth == whole->answers[i].truth);
      }
    }
  }
  CHECK(open > 0);
}

TEST_CASE("a count on a full disk ends with the reason") {
  constexpr std::uint64_t kLarge = 13; // seed of a model with many classes
  SpillInMemory full;
  full.problem = [](std::uint64_t now) { return now > 20 ? "it is full" : ""; };
  const auto counted = verify::countClasses(randomModel(kLarge), {.spill = &full, .spillBytes = 1});
  REQUIRE(counted.has_value());
  CHECK_FALSE(counted->complete);
  CHECK(counted->stopped == "it is full");
}

TEST_CASE("a file that another program has changed ends a search") {
  SpillInMemory disk;
  std::uint64_t reads = 0;
  disk.onRead = [&](std::span<char> page) {
    if (++reads == 30) page[page.size() / 2] ^= 1;
  };
  const auto program = randomModelWithData(1);
  const auto answered =
      verify::verify(program, {}, allOf(program),
                     {.reductions = without({Reduction::Slices, Reduction::Refinement}),
                      .spill = &disk,
                      .spillBytes = 1});
  REQUIRE(answered.has_value());
  CHECK_FALSE(answered->exploration.complete);
  CHECK(answered->exploration.stopped ==
        "a file of the search on disk was changed by another program");
}

TEST_CASE("a search on disk ends at its limits of time and classes, and when it is cancelled") {
  const auto program = randomModelWithData(1);
  SpillInMemory disk;
  verify::Options options{.reductions = without({Reduction::Slices, Reduction::Refinement}),
                          .spill = &disk,
                          .spillBytes = 1};
  const auto stoppedBy = [&](const verify::Options& limited) {
    return verify::verify(program, {}, allOf(program), limited).value().exploration.stopped;
  };
  auto limited = options;
  limited.limits.classes = 20;
  CHECK(stoppedBy(limited) == "the limit of classes was reached");
  limited = options;
  limited.clock = [&] { return disk.operations > 50 ? 1.0 : 0.0; };
  disk.operations = 0;
  limited.limits.seconds = 0.5;
  CHECK(stoppedBy(limited) == "the time limit was reached");
  std::atomic<bool> cancelled = false;
  limited = options;
  limited.cancelled = &cancelled;
  disk.onRead = [&](std::span<char>) { cancelled = true; };
  CHECK(stoppedBy(limited) == "cancelled");
}

} // namespace proskill::test::spill_test
