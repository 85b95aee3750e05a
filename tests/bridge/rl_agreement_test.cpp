#include "bridge/rl/emit.h"
#include "bridge/rl/import.h"
#include "bridge/rl/read/read.h"
#include "codegen/model.h"
#include "tests/bridge/random_skillset.h"
#include "tests/bridge/skillset_runs.h"
#include "tests/support/memory_files.h"
#include "tests/support/random/seeds.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

#include <fmt/format.h>

using namespace proskill;
using namespace proskill::test;

namespace rl_agreement {

namespace {

std::string importedText(const std::string& skillset) {
  const auto imported = bridge::rl::importSkillsets(MemoryFiles({{"s.rl", skillset}}), "s.rl", {});
  if (!imported) FAIL(imported.error().front().message << "\n" << skillset);
  CHECK(imported->exact);
  return imported->text;
}

std::string emittedText(const std::string& program) {
  const MemoryFiles files({{"p", program}});
  const auto emitted = bridge::rl::emitSkillset(analysis::load(files, "p"), "s");
  if (!emitted) FAIL(emitted.error().front().message << "\n" << program);
  CHECK(emitted->notes.empty());
  return emitted->text;
}

/// The observations that the verifier finds possible in a program.
std::set<std::string> verified(const std::string& text, const std::set<std::string>& asked) {
  auto program = text;
  std::vector<std::string> order(asked.begin(), asked.end());
  for (std::size_t i = 0; i < order.size(); ++i)
    program += fmt::format("(defproperty q_{} (reachable ({})))\n", i, order[i]);
  const auto loaded = analysis::load(MemoryFiles({{"p", program}}), "p");
  for (const auto& finding : analysis::check(loaded))
    if (finding.severity == syntax::Severity::Error) FAIL(finding.message << "\n" << program);
  const auto model = codegen::generate(loaded, {});
  REQUIRE(model);
  std::vector<verify::Question> questions;
  std::vector<std::size_t> numbers;
  for (const auto& check : model->checks)
    if (check.name.starts_with("q_")) {
      questions.push_back({check.property, check.fair, check.exempt, check.rests});
      numbers.push_back(std::stoul(check.name.substr(2)));
    }
  const auto result = verify::verify(model->fiacre, model->provenance, questions, {});
  REQUIRE(result);
  std::set<std::string> found;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    REQUIRE(result->answers[i].truth != verify::Truth::Unknown);
    if (result->answers[i].truth == verify::Truth::False) found.insert(order[numbers[i]]);
  }
  return found;
}

std::string inWords(const std::set<std::string>& observations) {
  std::string text;
  for (const auto& each : observations) text += each + "; ";
  return text;
}

void compare(std::uint64_t seed) {
  const auto skillset = randomSkillset(seed);
  const auto read = bridge::rl::read(MemoryFiles({{"s.rl", skillset}}), "s.rl");
  REQUIRE(read);
  const auto asked = allObservations(read->skillsets.front());
  const auto expected = observe(read->skillsets.front());
  const auto text = importedText(skillset);
  const auto found = verified(text, asked);
  INFO("seed " << seed << "\n" << skillset << "\n" << text);
  INFO("expected: " << inWords(expected) << "\nverified: " << inWords(found));
  REQUIRE(found == expected);
  const auto again = emittedText(text);
  INFO("written:\n" << again);
  REQUIRE(verified(importedText(again), asked) == expected);
  REQUIRE(emittedText(importedText(again)) == again);
}

} // namespace

TEST_CASE("the verdicts on random skillsets are those of their runs, also after a round trip") {
  const auto seeds = seedsOr(1, 400);
  for (auto seed = seeds.first; seed < seeds.end; ++seed) compare(seed);
}

} // namespace rl_agreement
