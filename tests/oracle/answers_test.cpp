#include "tests/support/random/random_program.h"
#include "tests/support/random/seeds.h"
#include "tests/support/texts.h"

#include "codegen/model.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

constexpr std::uint64_t kLargePrograms = 600;

struct Questions {
  std::size_t programs = 0;
  std::size_t questions = 0;
  std::size_t decided = 0;
};

/// Asks all questions about a program that may be too large for the oracle. An answer may be
/// missing because of a limit, but never because its trace could not be made.
void askAll(std::uint64_t seed, const test::ProgramSize& size, Questions& tally) {
  const auto text = test::textOf(test::randomProgram(seed, test::varied(seed, size)));
  const auto model = codegen::generate(test::programOfText(text));
  INFO("seed " << seed << "\n" << text);
  REQUIRE(model.has_value());
  std::vector<verify::Question> questions;
  for (const auto& check : model->checks) questions.push_back({check.property});
  verify::Options options;
  options.limits.classes = 4'000;
  const auto result = verify::verify(model->fiacre, model->provenance, questions, options);
  REQUIRE(result.has_value());
  ++tally.programs;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const auto& answer = result->answers[i];
    INFO(model->checks[i].description);
    CHECK(answer.reason.find("internal error") == std::string::npos);
    ++tally.questions;
    tally.decided += answer.truth != verify::Truth::Unknown ? 1 : 0;
  }
}

} // namespace

TEST_CASE("every witness of a large random program is made and replayed") {
  const test::ProgramSize nested{.basicSkills = 2,
                                 .composites = 2,
                                 .statements = 4,
                                 .depth = 3,
                                 .branches = 3,
                                 .properties = 4,
                                 .environment = 70};
  Questions tally;
  const auto seeds = test::seedsOr(0, kLargePrograms);
  for (auto seed = seeds.first; seed < seeds.end; ++seed) askAll(seed, nested, tally);
  WARN(tally.programs << " programs, " << tally.questions << " questions, " << tally.decided
                      << " decided");
  CHECK(tally.decided > tally.questions / 2);
}
