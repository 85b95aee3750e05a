#include "tests/oracle/agreement.h"
#include "tests/support/oracle/point_judge.h"
#include "tests/support/random/random_model.h"
#include "tests/support/random/random_program.h"
#include "tests/support/random/random_source.h"
#include "tests/support/random/seeds.h"
#include "tests/support/texts.h"

#include "codegen/model.h"
#include "fiacre/check/check.h"
#include "fiacre/print/print.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

#include <span>

namespace proskill::test::runs_test {

using fiacre::Interval;
using fiacre::Ltl;
using fiacre::LtlKind;
using fiacre::Observable;
using fiacre::ObservableKind;
using fiacre::Pattern;
using fiacre::PatternKind;
using test::RandomSource;
using Setting = std::pair<std::string, verify::Options>;

namespace {

constexpr std::int64_t kLongest = 4; ///< time in a pattern

/// The properties of a random model, as parts of patterns.
Observable observable(RandomSource& random, const fiacre::Program& program) {
  std::vector<Observable> asked;
  for (const auto& property : program.properties)
    for (const auto& operand : property.pattern.operands) asked.push_back(operand);
  const Observable all = asked.empty() ? Observable{.path = {1}, .name = "s1"} : random.pick(asked);
  if (random.chance(15)) return {.kind = ObservableKind::Not, .operands = {all}};
  if (all.kind == ObservableKind::State && random.chance(25))
    return {.kind = ObservableKind::Enter, .operands = {all}};
  return all;
}

Interval interval(RandomSource& random) {
  Interval made{.lower = random.chance(50) ? 0 : random.between(0, kLongest - 1)};
  made.lowerOpen = random.chance(25);
  if (random.chance(20)) return made;
  made.upper = random.between(made.lower + (made.lowerOpen ? 1 : 0), kLongest);
  made.upperOpen = *made.upper > made.lower + 1 && random.chance(25);
  return made;
}

Pattern pattern(RandomSource& random, const fiacre::Program& program) {
  static const std::vector<PatternKind> kKinds{
      PatternKind::LeadsTo,  PatternKind::LeadsTo,         PatternKind::Present,
      PatternKind::Absent,   PatternKind::Always,          PatternKind::Present,
      PatternKind::Precedes, PatternKind::InfinitelyOften, PatternKind::Mortal};
  Pattern made{.kind = random.pick(kKinds), .operands = {observable(random, program)}};
  const bool two = made.kind == PatternKind::LeadsTo || made.kind == PatternKind::Precedes;
  if (two) made.operands.push_back(observable(random, program));
  if (made.kind == PatternKind::InfinitelyOften || made.kind == PatternKind::Mortal) return made;
  const auto scope = random.below(6);
  if (scope == 0 || scope > 3) made.after = observable(random, program);
  if (scope > 3) made.until = observable(random, program);
  made.between = scope == 5;
  if (scope == 1) made.before = observable(random, program);
  if (made.kind == PatternKind::Precedes) return made;
  if (made.kind == PatternKind::Present && (scope == 0 || scope == 2 || scope == 3) &&
      random.chance(30)) {
    made.lasting = random.between(1, kLongest);
    return made;
  }
  if (random.chance(70)) made.within = interval(random);
  if (made.kind == PatternKind::LeadsTo) made.first = scope != 1 && random.chance(40);
  const bool absent = made.kind == PatternKind::Absent || made.kind == PatternKind::Always;
  if (absent && scope == 1 && random.chance(50)) {
    made.within.reset();
    made.forDuration = random.between(1, kLongest);
  }
  return made;
}

Ltl formula(RandomSource& random, const fiacre::Program& program, int depth, int& temporal) {
  if (depth == 0 || random.chance(15)) return {.atom = observable(random, program)};
  const auto inner = [&] { return formula(random, program, depth - 1, temporal); };
  static const std::vector<LtlKind> kOfTime{LtlKind::Globally, LtlKind::Finally, LtlKind::Until,
                                            LtlKind::Next};
  static const std::vector<LtlKind> kPlain{LtlKind::Not, LtlKind::And, LtlKind::Or,
                                           LtlKind::Implies};
  const bool ofTime = temporal > 0 && random.chance(65);
  if (ofTime) --temporal;
  Ltl made{.kind = random.pick(ofTime ? kOfTime : kPlain)};
  const bool one = made.kind == LtlKind::Globally || made.kind == LtlKind::Finally ||
                   made.kind == LtlKind::Next || made.kind == LtlKind::Not;
  made.operands.push_back(inner());
  if (!one) made.operands.push_back(inner());
  return made;
}

/// The engine's answer under each setting; it has a trace if it is negative.
/// \param sliced counts the answers by slices; may be null
bool answer(fiacre::Program program, const fiacre::Provenance& origins, const Pattern& asked,
            std::span<const Setting> settings, std::uint64_t* sliced = nullptr) {
  program.properties = {{.name = "p", .pattern = asked}};
  std::optional<bool> known;
  for (const auto& [name, options] : settings) {
    const auto result = verify::verify(program, origins, {{0}}, options);
    INFO(name << (result ? "" : ": " + result.error().message));
    REQUIRE(result.has_value());
    const auto& given = result->answers[0];
    INFO(given.reason);
    REQUIRE(given.truth != verify::Truth::Unknown);
    const bool truth = given.truth == verify::Truth::True;
    CHECK(given.trace.has_value() == !truth);
    CHECK(known.value_or(truth) == truth);
    known = truth;
    if (sliced) *sliced += result->exploration.sliced;
  }
  return *known;
}

/// With all reductions, and with none.
std::span<const Setting> bothEnds() { return std::span(oracle::settings()).first(2); }

/// Also with slices for questions about runs.
std::vector<Setting> withSlicesOfRuns() {
  std::vector<Setting> made(bothEnds().begin(), bothEnds().end());
  made.emplace_back("slices first", verify::Options{.classesBeforeSlices = 0});
  made.emplace_back("refinement alone",
                    verify::Options{.reductions = {verify::Reduction::Refinement,
                                                   verify::Reduction::Extrapolation},
                                    .classesBeforeSlices = 0});
  return made;
}

struct Tally {
  std::uint64_t sliced = 0;
  std::size_t compared = 0;
  std::size_t violated = 0;

  void check(std::size_t least) const {
    INFO(compared << " compared, " << violated << " violated");
    CHECK(compared > least);
    CHECK(violated > compared / 5);
    CHECK(violated < compared * 4 / 5);
  }
};

/// Compares the answers to random patterns with those of the oracle, if it can decide them.
void comparePatterns(const fiacre::Program& program, const fiacre::Provenance& origins,
                     std::uint64_t seed, std::span<const Setting> settings, Tally& tally) {
  const oracle::Interpreter model(program);
  const oracle::RegionGraph graph(model, 1500, kLongest + 1);
  if (!graph.complete()) return;
  RandomSource random(seed + 1);
  for (int i = 0; i < 6; ++i) {
    const auto asked = pattern(random, program);
    INFO("seed " << seed << ": " << fiacre::printPattern(asked, program.main) << "\n"
                 << fiacre::print(program));
    const auto expected = oracle::isTrueOfPoints(model, graph, asked);
    if (!expected) continue;
    REQUIRE(answer(program, origins, asked, settings, &tally.sliced) == *expected);
    ++tally.compared;
    tally.violated += *expected ? 0 : 1;
  }
}

} // namespace

TEST_CASE("patterns with scopes and times are decided as point by point, on random models") {
  Tally tally;
  const auto settings = withSlicesOfRuns();
  const auto seeds = test::seedsOr(0, 1000);
  for (auto seed = seeds.first; seed < seeds.end; ++seed)
    comparePatterns(seed % 4 == 3 ? test::randomModelWithData(seed) : test::randomModel(seed), {},
                    seed, settings, tally);
  INFO(tally.sliced << " by slices");
  tally.check((seeds.end - seeds.first) / 2);
  CHECK(tally.sliced > tally.compared / 10);
}

TEST_CASE("patterns are decided as point by point, on random programs, whatever is reduced") {
  Tally tally;
  const auto seeds = test::seedsOr(0, 400);
  const test::ProgramSize small{.basicSkills = 1, .composites = 0, .halves = 0};
  for (auto seed = seeds.first; seed < seeds.end; ++seed) {
    const auto forms = test::randomProgram(seed, small);
    const auto made = codegen::generate(test::programOfText(test::textOf(forms)));
    REQUIRE(made.has_value());
    std::vector<Setting> settings{oracle::settings()[0]};
    settings.push_back(oracle::settings()[1 + seed % (oracle::settings().size() - 1)]);
    comparePatterns(made->fiacre, made->provenance, seed, settings, tally);
  }
  tally.check(seeds.end - seeds.first);
}

TEST_CASE("formulas of LTL are decided as by all that may be true of a position") {
  std::size_t compared = 0;
  std::size_t violated = 0;
  const auto [first, end] = test::seedsOr(0, 1500);
  for (auto seed = first; seed < end; ++seed) {
    const auto program = seed % 4 == 3 ? test::randomModelWithData(seed) : test::randomModel(seed);
    const oracle::Interpreter model(program);
    const oracle::RegionGraph graph(model, 150);
    if (!graph.complete()) continue;
    RandomSource random(seed + 2);
    for (int i = 0; i < 4; ++i) {
      int temporal = 3;
      const Pattern asked{.kind = PatternKind::Ltl, .ltl = formula(random, program, 4, temporal)};
      INFO("seed " << seed << ": " << fiacre::printPattern(asked, program.main) << "\n"
                   << fiacre::print(program));
      const bool expected = oracle::isTrueOfRuns(model, graph, asked.ltl);
      REQUIRE(answer(program, {}, asked, bothEnds()) == expected);
      ++compared;
      violated += expected ? 0 : 1;
    }
  }
  INFO(compared << " compared, " << violated << " violated");
  CHECK(compared > (end - first) / 3);
  CHECK(violated > compared / 5);
}

} // namespace proskill::test::runs_test
