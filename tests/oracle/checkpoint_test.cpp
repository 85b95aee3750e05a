#include "tests/oracle/agreement.h"
#include "tests/support/checkpoint_in_memory.h"
#include "tests/support/random/random_model.h"
#include "tests/support/random/random_program.h"
#include "tests/support/random/seeds.h"
#include "tests/support/texts.h"

#include "codegen/model.h"
#include "fiacre/print/print.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace proskill::test::checkpoint_test {

namespace {

constexpr std::uint64_t kModels = 180;
constexpr std::uint64_t kPrograms = 40;
constexpr std::uint64_t kMostClasses = 2'000;
constexpr std::uint64_t kMostOfParts = 40'000; ///< more than is tried with parts

std::string textOf(const verify::Trace& trace) {
  std::string text = fmt::format(" {} {} {} {}", trace.scale, trace.end, trace.loop.value_or(9999),
                                 static_cast<int>(trace.rest));
  for (const auto& step : trace.steps) {
    text += fmt::format(" {}-{}@{}", step.earliest.value, step.latest ? step.latest->value : -1,
                        step.date);
    for (const auto& name : step.transitions) text += " " + name;
  }
  return text;
}

/// Everything that must be the same, however often a verification was interrupted.
std::string textOf(const verify::Result& result) {
  const auto& all = result.exploration;
  std::string text = fmt::format(
      "{} classes {} markings {} domains {} transitions {} sliced {} {}\n", all.classes,
      all.markings, all.domains, all.transitions, all.sliced, all.complete, all.stopped);
  for (const auto& answer : result.answers) {
    text += fmt::format("{} {} {}", static_cast<int>(answer.truth), answer.reason,
                        answer.steps.value_or(9999));
    if (const auto& time = answer.duration)
      text += fmt::format(" {} {} {} {}", time->happens, time->bounded, time->value.value,
                          time->value.strict);
    if (answer.trace) text += textOf(*answer.trace);
    text += "\n";
  }
  return text;
}

struct Subject {
  const fiacre::Program& program;
  const fiacre::Provenance& provenance;
  std::vector<verify::Question> questions;
};

verify::Result verified(const Subject& subject, const verify::Options& options) {
  auto result = verify::verify(subject.program, subject.provenance, subject.questions, options);
  INFO((result ? "" : result.error().message));
  REQUIRE(result);
  return std::move(*result);
}

/// Interrupts a verification at random numbers of classes, and goes on each time from what it saved
/// last. \return the report at its end
std::string interrupted(const Subject& subject, verify::Options options, std::mt19937_64& random,
                        std::size_t& times) {
  std::string state;
  std::uint64_t limit = 0;
  for (int round = 0;; ++round) {
    CheckpointInMemory store;
    if (!state.empty()) store.give(state);
    limit += 1 + random() % (1U << std::min(round, 12));
    options.limits.classes = round < 40 ? limit : kMostOfParts;
    options.checkpoint = &store;
    const auto result = verified(subject, options);
    if (!state.empty() && store.wasUsed) ++times;
    if (store.isFinished) return textOf(result);
    if (!store.saved.empty()) state = store.saved.back();
  }
}

/// Goes on from some state that a verification saved on its way, as after a kill at that moment.
void tryKills(const Subject& subject, verify::Options options, const std::string& expected,
              std::mt19937_64& random, std::size_t& times) {
  CheckpointInMemory store(static_cast<unsigned>(1 + random() % 20), random());
  options.checkpoint = &store;
  REQUIRE(textOf(verified(subject, options)) == expected);
  for (int tries = 0; tries < 2 && !store.saved.empty(); ++tries) {
    CheckpointInMemory again(static_cast<unsigned>(1 + random() % 50), random());
    again.give(store.saved[random() % store.saved.size()]);
    options.checkpoint = &again;
    REQUIRE(textOf(verified(subject, options)) == expected);
    REQUIRE(again.isFinished);
    ++times;
  }
}

struct Tally {
  std::size_t subjects = 0;
  std::size_t times = 0;
};

/// Without extrapolation, a model may have infinitely many classes.
bool isLimited(const verify::Result& result) {
  const auto namesOne = [](const std::string& reason) {
    return reason.find("limit") != std::string::npos;
  };
  return namesOne(result.exploration.stopped) ||
         std::ranges::any_of(result.answers, namesOne, &verify::Answer::reason);
}

void tryAll(const Subject& subject, std::uint64_t seed, Tally& tally) {
  const auto& settings = oracle::settings();
  for (std::size_t i = seed % 6; i < settings.size(); i += 6) {
    verify::Options options = settings[i].second;
    options.limits.classes = kMostClasses;
    const auto plain =
        verify::verify(subject.program, subject.provenance, subject.questions, options);
    if (!plain || isLimited(*plain)) continue;
    options.limits.classes = kMostOfParts; // a part may meet a limit that the whole does not
    const auto unlimited =
        verify::verify(subject.program, subject.provenance, subject.questions, options);
    REQUIRE(unlimited);
    INFO("seed " << seed << ", " << settings[i].first << "\n" << fiacre::print(subject.program));
    std::mt19937_64 random(seed);
    const auto expected = textOf(*unlimited);
    REQUIRE(interrupted(subject, options, random, tally.times) == expected);
    tryKills(subject, options, expected, random, tally.times);
    ++tally.subjects;
  }
}

} // namespace

TEST_CASE("a verification of a random model that is interrupted and resumed has the same result") {
  Tally tally;
  const auto seeds = test::seedsOr(0, kModels);
  for (auto seed = seeds.first; seed < seeds.end; ++seed) {
    const auto program = test::randomModel(seed);
    const fiacre::Provenance provenance;
    Subject subject{program, provenance, {}};
    for (std::size_t i = 0; i < program.properties.size(); ++i) subject.questions.push_back({i});
    tryAll(subject, seed, tally);
  }
  WARN(tally.subjects << " verifications, resumed " << tally.times << " times");
  CHECK(tally.times > 2 * tally.subjects);
}

TEST_CASE(
    "a verification of a random program that is interrupted and resumed has the same result") {
  Tally tally;
  const auto seeds = test::seedsOr(0, kPrograms);
  for (auto seed = seeds.first; seed < seeds.end; ++seed) {
    const auto text = test::textOf(test::randomProgram(seed, {.properties = 4, .scopes = 40}));
    const auto model = codegen::generate(test::programOfText(text));
    REQUIRE(model.has_value());
    Subject subject{model->fiacre, model->provenance, {}};
    for (const auto& check : model->checks)
      subject.questions.push_back({check.property, check.fair, check.exempt, check.rests});
    tryAll(subject, seed, tally);
  }
  WARN(tally.subjects << " verifications, resumed " << tally.times << " times");
  CHECK(tally.times > 2 * tally.subjects);
}

} // namespace proskill::test::checkpoint_test
