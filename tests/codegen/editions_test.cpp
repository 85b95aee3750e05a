#include "codegen/model.h"
#include "tests/support/random/random_program.h"
#include "tests/support/texts.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

#include <map>

using namespace proskill;
using codegen::Edition;
using verify::Truth;

namespace {

/// The engine's verdict on each check that it can decide; empty if the model is too large for a
/// test.
std::optional<std::map<std::string, Truth>> verdicts(const std::string& text, Edition edition) {
  const auto program = test::programOfText(text);
  const auto model = codegen::generate(program, {.edition = edition});
  REQUIRE(model.has_value());
  std::vector<verify::Question> questions;
  for (const auto& check : model->checks) questions.push_back({check.property});
  verify::Options options;
  options.limits.classes = 20'000;
  const auto result = verify::verify(model->fiacre, model->provenance, questions, options);
  if (!result) FAIL(result.error().message);
  if (!result->exploration.complete) return std::nullopt;
  std::map<std::string, Truth> truths;
  for (std::size_t i = 0; i < questions.size(); ++i)
    if (result->answers[i].truth != Truth::Unknown)
      truths[model->checks[i].name] = result->answers[i].truth;
  return truths;
}

std::string differences(const std::map<std::string, Truth>& compact,
                        const std::map<std::string, Truth>& expanded) {
  std::string names;
  for (const auto& [name, truth] : compact)
    if (const auto other = expanded.find(name); other != expanded.end() && other->second != truth)
      names += name + " ";
  return names;
}

} // namespace

TEST_CASE("the compact, the expanded and Tina's edition of a program have the same verdicts") {
  std::size_t compared = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    test::ProgramSize size;
    size.properties = 0; // the expanded edition has more steps, which a property of steps may
                         // observe
    const auto text = test::textOf(test::randomProgram(seed, test::varied(seed, size)));
    const auto compact = verdicts(text, Edition::Compact);
    if (!compact) continue;
    const auto expanded = verdicts(text, Edition::Expanded);
    if (!expanded) continue;
    INFO("seed " << seed << "\n" << text);
    CHECK(differences(*compact, *expanded) == "");
    ++compared;
    if (seed % 5 != 0) continue;
    if (const auto tina = verdicts(text, Edition::Tina)) CHECK(differences(*expanded, *tina) == "");
  }
  CHECK(compared > 300);
}
