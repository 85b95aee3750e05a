#include "tests/support/random/random_model.h"
#include "tests/support/random/random_program.h"
#include "tests/support/random/seeds.h"
#include "tests/support/result_text.h"
#include "tests/support/texts.h"

#include "codegen/model.h"
#include "fiacre/print/print.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

namespace proskill::test::threads_test {

namespace {

/// All reductions, none but those that make timed models finite, or none.
verify::Options optionsOf(std::uint64_t seed) {
  using verify::Reduction;
  verify::Options options;
  if (seed % 3 == 1) options.reductions = {Reduction::Inclusion, Reduction::Extrapolation};
  if (seed % 3 == 2) options.reductions = {Reduction::LiveVariables, Reduction::FreeInputs};
  options.limits.classes = 3000;
  options.classesBeforeThreads = 0;
  options.nodesBeforeThreads = 1;
  return options;
}

/// Asks all questions with 1, 2, 3, and 8 threads, which start at once. \return number of classes
std::uint64_t compare(const fiacre::Program& program, const fiacre::Provenance& provenance,
                      std::uint64_t seed) {
  std::vector<verify::Question> questions;
  for (std::size_t i = 0; i < program.properties.size(); ++i) questions.push_back({i});
  verify::Options options = optionsOf(seed);
  const auto alone = verify::verify(program, provenance, questions, options);
  REQUIRE(alone.has_value());
  for (const unsigned jobs : {2U, 3U, 8U}) {
    options.jobs = jobs;
    INFO("seed " << seed << ", " << jobs << " threads\n" << fiacre::print(program));
    const auto together = verify::verify(program, provenance, questions, options);
    REQUIRE(together.has_value());
    REQUIRE(textOf(*together) == textOf(*alone));
  }
  return alone->exploration.classes;
}

} // namespace

TEST_CASE("random models have the same answers, counts and traces for each number of threads") {
  std::uint64_t classes = 0;
  const auto [first, end] = seedsOr(0, 150);
  for (auto seed = first; seed < end; ++seed) {
    classes += compare(randomModel(seed), {}, seed);
    classes += compare(randomModelWithData(seed), {}, seed);
  }
  CHECK(classes > 100 * (end - first));
}

TEST_CASE("random programs have the same answers, counts and traces for each number of threads") {
  std::uint64_t classes = 0;
  const auto [first, end] = seedsOr(0, 100);
  for (auto seed = first; seed < end; ++seed) {
    const auto text = textOf(randomProgram(seed, varied(seed, {})));
    const auto model = codegen::generate(programOfText(text));
    INFO(text);
    REQUIRE(model.has_value());
    classes += compare(model->fiacre, model->provenance, seed);
  }
  CHECK(classes > 100 * (end - first));
}

} // namespace proskill::test::threads_test
