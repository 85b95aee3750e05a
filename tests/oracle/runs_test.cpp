#include "tests/support/oracle/point_judge.h"
#include "tests/support/random/random_model.h"
#include "tests/support/random/random_source.h"

#include "fiacre/check/check.h"
#include "fiacre/print/print.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

namespace proskill::test::runs_test {

using fiacre::Interval;
using fiacre::Ltl;
using fiacre::LtlKind;
using fiacre::Observable;
using fiacre::ObservableKind;
using fiacre::Pattern;
using fiacre::PatternKind;
using test::RandomSource;

namespace {

constexpr std::int64_t kLongest = 4; ///< time in a pattern

/// What a random model asks for, as something to make patterns of.
Observable observable(RandomSource& random, const fiacre::Program& program) {
  Observable all = random.pick(program.properties).pattern.operands.empty()
                       ? Observable{.path = {1}, .name = "s1"}
                       : Observable{};
  while (all.name.empty() && all.operands.empty() && all.kind != ObservableKind::Value) {
    const auto& operands = random.pick(program.properties).pattern.operands;
    if (!operands.empty()) all = operands[0];
  }
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

/// The answer of the engine, the same whatever is reduced; it has a trace where it is no.
bool answer(fiacre::Program program, const Pattern& asked) {
  program.properties = {{.name = "p", .pattern = asked}};
  std::optional<bool> known;
  for (bool reduced : {true, false}) {
    verify::Options options;
    if (!reduced) options.reductions.clear();
    const auto result = verify::verify(program, {}, {{0}}, options);
    REQUIRE(result.has_value());
    const auto& given = result->answers[0];
    INFO((reduced ? "reduced: " : "not reduced: ") << given.reason);
    REQUIRE(given.truth != verify::Truth::Unknown);
    const bool truth = given.truth == verify::Truth::True;
    CHECK(given.trace.has_value() == !truth);
    CHECK(known.value_or(truth) == truth);
    known = truth;
  }
  return *known;
}

} // namespace

TEST_CASE("patterns with scopes and times are decided as point by point, on random models") {
  std::size_t compared = 0;
  std::size_t violated = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const auto program = seed % 4 == 3 ? test::randomModelWithData(seed) : test::randomModel(seed);
    const oracle::Interpreter model(program);
    const oracle::RegionGraph graph(model, 1500, kLongest + 1);
    if (!graph.complete()) continue;
    RandomSource random(seed + 1);
    for (int i = 0; i < 6; ++i) {
      const auto asked = pattern(random, program);
      INFO("seed " << seed << ": " << fiacre::printPattern(asked, program.main) << "\n"
                   << fiacre::print(program));
      const auto expected = oracle::isTrueOfPoints(model, graph, asked);
      if (!expected) continue;
      REQUIRE(answer(program, asked) == *expected);
      ++compared;
      violated += *expected ? 0 : 1;
    }
  }
  INFO(compared << " compared, " << violated << " violated");
  CHECK(compared > 500);
  CHECK(violated > compared / 5);
  CHECK(violated < compared * 4 / 5);
}

TEST_CASE("formulas of LTL are decided as by all that may be true of a position") {
  std::size_t compared = 0;
  std::size_t violated = 0;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
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
      REQUIRE(answer(program, asked) == expected);
      ++compared;
      violated += expected ? 0 : 1;
    }
  }
  INFO(compared << " compared, " << violated << " violated");
  CHECK(compared > 500);
  CHECK(violated > compared / 5);
}

} // namespace proskill::test::runs_test
