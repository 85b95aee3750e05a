#include "tests/meaning/agreement.h"
#include "tests/support/random/random_constants.h"
#include "tests/support/random/random_program.h"
#include "tests/support/random/seeds.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <map>
#include <string_view>

using namespace proskill;

namespace {

constexpr std::size_t kLimit = 1500; ///< situations of a program

struct Tally {
  std::uint64_t programs = 0;
  std::uint64_t tooLarge = 0;
  std::uint64_t questions = 0;
  std::uint64_t limited = 0;
  std::uint64_t scopes = 0;
  std::uint64_t traces = 0;
  std::uint64_t situations = 0;
  std::map<std::string, std::uint64_t> disagreements; ///< by kind
};

/// The first of each kind is shown, reduced to a minimum.
void note(Tally& tally, std::uint64_t seed, const std::string& kind,
          const std::vector<test::Form>& program, const verify::Options& options,
          codegen::Edition edition) {
  if (++tally.disagreements[kind] > 1) return;
  WARN("seed " << seed << ", " << kind);
  UNSCOPED_INFO("seed " << seed << ", " << kind << "\n"
                        << meaning::smallest(program, kLimit, options, edition));
}

/// Every tenth program has constants in place of its numbers.
std::vector<test::Form> programOf(std::uint64_t seed, const test::ProgramSize& size) {
  const auto program = test::randomProgram(seed, size);
  return seed % 10 == 0 ? test::withConstants(program) : program;
}

/// Every tenth program is verified in the expanded edition, and all with
/// `PROSKILL_EDITION=expanded`. There, steps are more, so a formula about the next step means
/// something else.
codegen::Edition editionOf(std::uint64_t seed, const test::ProgramSize& size) {
  const char* asked = std::getenv("PROSKILL_EDITION");
  const bool isExpanded = (asked && std::string_view(asked) == "expanded") || seed % 10 == 5;
  return isExpanded && size.next == 0 ? codegen::Edition::Expanded : codegen::Edition::Compact;
}

/// Ten programs in turn are decided all at once, by slices and refinement, or by random runs and
/// led searches, which otherwise begin only after many more states than these programs have.
verify::Options optionsOf(std::uint64_t seed) {
  verify::Options options;
  if (seed / 10 % 3 == 1) options.classesBeforeSlices = 0;
  if (seed / 10 % 3 == 2) {
    options.classesBeforeSlices = 1;
    options.reductions.erase(verify::Reduction::Slices);
  }
  return options;
}

Tally compareAll(std::uint64_t first, std::uint64_t count, const test::ProgramSize& size) {
  Tally tally;
  const auto [begin, end] = test::seedsOr(first, count);
  for (auto seed = begin; seed < end; ++seed) {
    const auto program = programOf(seed, size);
    const auto edition = editionOf(seed, size);
    const auto options = optionsOf(seed);
    const auto comparison = meaning::compare(program, kLimit, options, edition);
    if (comparison.refusal) FAIL("seed " << seed << ": " << *comparison.refusal);
    if (comparison.disagreement) note(tally, seed, comparison.kind, program, options, edition);
    ++tally.programs;
    tally.tooLarge += comparison.tooLarge ? 1 : 0;
    tally.questions += comparison.questions;
    tally.limited += comparison.limited;
    tally.scopes += comparison.scopes;
    tally.traces += comparison.traces;
    tally.situations += comparison.situations;
  }
  std::string found;
  for (const auto& [kind, times] : tally.disagreements)
    found += "\n  " + kind + ": " + std::to_string(times);
  WARN(tally.programs << " programs, " << tally.tooLarge << " too large, " << tally.questions
                      << " questions (" << tally.scopes << " with scopes or times), "
                      << tally.limited << " left open at a limit, " << tally.traces << " traces, "
                      << tally.situations << " situations" << found);
  CHECK(tally.disagreements.empty());
  CHECK(tally.limited <= 1 + tally.questions / 1000);
  return tally;
}

} // namespace

TEST_CASE("the engine's verdicts are those of an interpreter of programs") {
  const auto tally = compareAll(0, 1200, {.properties = 4});
  CHECK(tally.tooLarge < tally.programs / 3);
  CHECK(tally.questions > tally.programs * 10);
  CHECK(tally.traces > tally.programs * 5);
}

TEST_CASE("so they are with several callers, resources and an environment") {
  const auto tally = compareAll(1'000'000, 600,
                                {.resources = 2,
                                 .basicSkills = 2,
                                 .composites = 2,
                                 .monitors = 2,
                                 .properties = 4,
                                 .seconds = 2,
                                 .halves = 0,
                                 .environment = 80});
  CHECK(tally.tooLarge < tally.programs * 2 / 3);
}

TEST_CASE("so are those of races") {
  const auto tally = compareAll(3'000'000, 600,
                                {.composites = 0,
                                 .monitors = 1,
                                 .statements = 2,
                                 .branches = 3,
                                 .properties = 4,
                                 .seconds = 2,
                                 .halves = 0,
                                 .forks = 70,
                                 .races = 80});
  CHECK(tally.tooLarge < tally.programs * 2 / 3);
}

TEST_CASE("so are those of inputs that conditions and effects read") {
  const auto tally = compareAll(4'000'000, 600, {.properties = 4, .library = 20, .inputs = 60});
  CHECK(tally.tooLarge < tally.programs / 2);
}

TEST_CASE("so are those of formulas about the next step") {
  const auto tally = compareAll(
      5'000'000, 600,
      {.naturals = 0, .composites = 0, .monitors = 1, .properties = 8, .open = 0, .next = 40});
  CHECK(tally.questions > tally.programs * 10);
}

TEST_CASE("so are those of patterns with scopes and times") {
  const auto tally = compareAll(
      2'000'000, 600,
      {.resources = 0, .composites = 0, .properties = 6, .seconds = 2, .halves = 0, .scopes = 80});
  CHECK(tally.scopes > tally.programs);
}
