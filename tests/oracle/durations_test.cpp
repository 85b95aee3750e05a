#include "tests/oracle/agreement.h"
#include "tests/support/oracle/duration_judge.h"
#include "tests/support/random/random_model.h"
#include "tests/support/random/random_program.h"
#include "tests/support/random/random_source.h"
#include "tests/support/random/seeds.h"
#include "tests/support/texts.h"

#include "codegen/model.h"
#include "fiacre/print/print.h"

#include <catch2/catch.hpp>

namespace proskill::test::durations_test {

using fiacre::Observable;
using fiacre::Pattern;
using fiacre::PatternKind;

namespace {

constexpr std::int64_t kWatched = 6; ///< times up to this one are known to the oracle

struct Tally {
  std::size_t compared = 0;
  std::size_t strict = 0;
  std::size_t unbounded = 0;
  std::size_t positive = 0;
};

std::string words(const verify::Duration& duration) {
  if (!duration.happens) return "never";
  if (!duration.bounded) return "unbounded";
  return std::to_string(duration.value.value) + (duration.value.strict ? ", excluded" : "");
}

/// Beyond the watch, a long time looks like an unbounded one to the oracle.
bool agree(const verify::Duration& engine, const verify::Duration& oracle) {
  if (oracle.happens && !oracle.bounded)
    return engine.happens && (!engine.bounded || engine.value.value >= kWatched);
  return engine == oracle;
}

std::vector<Observable> conditionsOf(const fiacre::Program& program) {
  std::vector<Observable> all;
  for (const auto& property : program.properties)
    for (const auto& operand : property.pattern.operands) all.push_back(operand);
  return all;
}

void compare(fiacre::Program program, const fiacre::Provenance& origins, std::uint64_t seed,
             Tally& tally) {
  const auto conditions = conditionsOf(program);
  if (conditions.empty()) return;
  const oracle::Interpreter model(program);
  const oracle::RegionGraph graph(model, 1500, kWatched);
  if (!graph.complete()) return;
  RandomSource random(seed + 3);
  for (int i = 0; i < 16; ++i) {
    const Pattern asked{.kind = i % 2 == 0 ? PatternKind::Longest : PatternKind::Shortest,
                        .operands = {random.pick(conditions), random.pick(conditions)}};
    const auto expected = oracle::durationOf(model, graph, asked);
    program.properties = {{.name = "p", .pattern = asked}};
    const auto& settings = oracle::settings();
    for (const auto at : {std::size_t{0}, 1 + (seed + i) % (settings.size() - 1)}) {
      auto options = settings[at].second;
      options.limits.classes = 200'000;
      const auto result = verify::verify(program, origins, {{0}}, options);
      INFO("seed " << seed << ": " << fiacre::printPattern(asked, program.main) << "\n"
                   << fiacre::print(program) << "with " << settings[at].first);
      REQUIRE(result.has_value());
      const auto& answer = result->answers[0];
      const bool mayStayOpen = !options.reductions.contains(verify::Reduction::Extrapolation);
      if (mayStayOpen && !answer.duration) continue;
      INFO(answer.reason);
      REQUIRE(answer.duration.has_value());
      INFO("engine: " << words(*answer.duration) << ", oracle: " << words(expected));
      REQUIRE(agree(*answer.duration, expected));
      CHECK(answer.trace.has_value() == expected.happens);
      options.showsTimes = false;
      const auto plain = verify::verify(program, origins, {{0}}, options);
      REQUIRE(plain->answers[0].duration.has_value());
      CHECK(*plain->answers[0].duration == *answer.duration);
    }
    ++tally.compared;
    if (expected.happens && expected.value.strict) ++tally.strict;
    if (expected.happens && !expected.bounded) ++tally.unbounded;
    if (expected.happens && expected.value.value > 0) ++tally.positive;
  }
}

void check(const Tally& tally, std::size_t least) {
  INFO(tally.compared << " compared, " << tally.strict << " strict, " << tally.unbounded
                      << " unbounded, " << tally.positive << " positive");
  CHECK(tally.compared > least);
  CHECK(tally.strict > least / 100);
  CHECK(tally.unbounded > least / 100);
  CHECK(tally.positive > least / 100);
}

} // namespace

TEST_CASE("longest and shortest times are those of the regions, on random models") {
  Tally tally;
  const auto seeds = test::seedsOr(0, 1000);
  for (auto seed = seeds.first; seed < seeds.end; ++seed)
    compare(seed % 4 == 3 ? test::randomModelWithData(seed) : test::randomModel(seed), {}, seed,
            tally);
  check(tally, seeds.end - seeds.first);
}

TEST_CASE("longest and shortest times are those of the regions, on random programs") {
  Tally tally;
  const auto seeds = test::seedsOr(0, 300);
  const test::ProgramSize small{.basicSkills = 1, .composites = 0, .halves = 0};
  for (auto seed = seeds.first; seed < seeds.end; ++seed) {
    const auto made =
        codegen::generate(test::programOfText(test::textOf(test::randomProgram(seed, small))));
    REQUIRE(made.has_value());
    compare(made->fiacre, made->provenance, seed, tally);
  }
  check(tally, seeds.end - seeds.first);
}

} // namespace proskill::test::durations_test
