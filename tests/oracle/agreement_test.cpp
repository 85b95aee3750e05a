#include "tests/oracle/agreement.h"
#include "tests/support/random/random_program.h"
#include "tests/support/random/seeds.h"
#include "tests/support/texts.h"

#include "codegen/model.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

constexpr std::uint64_t kPrograms = 1200;
constexpr std::size_t kLimit = 1500; ///< nodes of a region graph

using Setting = std::pair<std::string, verify::Options>;
using Asked = fiacre::Program (*)(fiacre::Program);

fiacre::Program defaultChecks(fiacre::Program program) { return program; }

/// The disagreements on a program; empty if it is too large for the oracle.
std::optional<std::string> quarrel(const std::vector<test::Form>& forms, Asked asked,
                                   const Setting& setting) {
  analysis::Program program = test::programOfText(test::textOf(forms));
  if (!test::isWellFormed(program)) return std::nullopt;
  auto model = codegen::generate(program);
  if (!model) return std::nullopt;
  fiacre::Program questions = asked(model->fiacre);
  oracle::Judged judged = oracle::judge(questions, kLimit);
  if (!judged.complete) return std::nullopt;
  return oracle::disagreement(questions, model->provenance, judged, setting);
}

/// The smallest program with a disagreement under this setting, and a description.
std::string report(std::uint64_t seed, Asked asked, const Setting& setting) {
  auto shows = [&](const std::vector<test::Form>& forms) {
    try {
      return quarrel(forms, asked, setting).has_value();
    } catch (const oracle::ModelError&) {
      return false;
    }
  };
  auto small = test::minimise(test::randomProgram(seed, test::varied(seed)), shows);
  return "seed " + std::to_string(seed) + "\n" + test::textOf(small) +
         quarrel(small, asked, setting).value();
}

struct Tally {
  std::size_t compared = 0;
  std::size_t tooLarge = 0;
  std::size_t nodes = 0;
  std::size_t answers = 0;
  std::size_t decided = 0; ///< over all settings
};

/// Compares under every `stride`-th setting, with a different first one for each program.
Tally compareAll(Asked asked, const test::Seeds& seeds, std::size_t stride) {
  Tally tally;
  for (auto seed = seeds.first; seed < seeds.end; ++seed) {
    auto model = codegen::generate(
        test::programOfText(test::textOf(test::randomProgram(seed, test::varied(seed)))));
    INFO("seed " << seed);
    REQUIRE(model.has_value());
    fiacre::Program questions = asked(model->fiacre);
    oracle::Judged judged = oracle::judge(questions, kLimit);
    if (!judged.complete) {
      ++tally.tooLarge;
      continue;
    }
    ++tally.compared;
    tally.nodes += judged.nodes;
    tally.answers += judged.truths.size();
    for (std::size_t i = seed % stride; i < oracle::settings().size(); i += stride) {
      const auto& setting = oracle::settings()[i];
      if (!oracle::disagreement(questions, model->provenance, judged, setting, &tally.decided))
        continue;
      FAIL(report(seed, asked, setting));
    }
  }
  return tally;
}

void show(const Tally& tally) {
  WARN(tally.compared << " programs compared, " << tally.tooLarge << " too large, " << tally.nodes
                      << " regions, " << tally.answers << " answers, " << tally.decided
                      << " questions decided");
}

} // namespace

TEST_CASE("engine and oracle agree on every check of random programs, whatever is reduced") {
  const auto seeds = test::seedsOr(0, kPrograms);
  const auto count = seeds.end - seeds.first;
  const auto tally = compareAll(defaultChecks, seeds, 5);
  show(tally);
  CHECK(tally.compared > count * 3 / 4);
  CHECK(tally.nodes > count * 67);
  CHECK(tally.answers > count * 17);
}

TEST_CASE("engine and oracle agree on the states and the tags that random programs reach") {
  const auto seeds = test::seedsOr(0, kPrograms / 2);
  const auto count = seeds.end - seeds.first;
  const auto tally = compareAll(oracle::askedForControl, seeds, 6);
  show(tally);
  CHECK(tally.compared > count * 3 / 4);
  CHECK(tally.answers > count * 50);
}
