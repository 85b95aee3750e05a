#include "tests/support/memory_files.h"
#include "tests/support/models.h"

#include "codegen/model.h"
#include "fiacre/check/check.h"
#include "fiacre/syntax/parse.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

using namespace proskill;
using verify::Truth;

namespace {

/// The files of an example, as they are in the tree.
codegen::Model example(const std::string& folder, const std::string& root) {
  std::map<std::string, std::string> texts;
  const std::filesystem::path place =
      std::filesystem::path(PROSKILL_SOURCE_DIR) / "examples" / folder;
  for (const auto& entry : std::filesystem::directory_iterator(place)) {
    std::stringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    texts[entry.path().filename()] = text.str();
  }
  auto model = codegen::generate(analysis::load(test::MemoryFiles(texts), root));
  REQUIRE(model.has_value());
  return std::move(*model);
}

verify::Result answers(const codegen::Model& model, const verify::Options& options) {
  std::vector<verify::Question> questions;
  for (std::size_t i = 0; i < model.fiacre.properties.size(); ++i) questions.push_back({i});
  auto result = verify::verify(model.fiacre, model.provenance, questions, options);
  REQUIRE(result.has_value());
  return std::move(*result);
}

} // namespace

TEST_CASE("the models in Fiacre have the verdicts that they tell") {
  std::size_t models = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(PROSKILL_SOURCE_DIR "/examples/fiacre")) {
    if (entry.path().extension() != ".fcr") continue;
    ++models;
    std::stringstream read;
    read << std::ifstream(entry.path()).rdbuf();
    const std::string text = read.str();
    const auto parsed = fiacre::parse(text);
    REQUIRE(parsed.problems.empty());
    REQUIRE(fiacre::check(parsed.program).empty());
    std::vector<verify::Question> questions;
    for (std::size_t i = 0; i < parsed.program.properties.size(); ++i)
      if (parsed.program.properties[i].asserted) questions.push_back({i});
    CHECK(questions.size() >= 2);
    const auto result = verify::verify(parsed.program, parsed.provenance, questions);
    REQUIRE(result.has_value());
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const auto& name = parsed.program.properties[questions[i].property].name;
      const auto place = text.find("\nproperty " + name + " ");
      REQUIRE(place != std::string::npos);
      const auto line = text.rfind('\n', place - 1) + 1;
      const bool violated = text.substr(line, place - line).starts_with("// violated");
      INFO(entry.path().filename() << ": " << name);
      CHECK(result->answers[i].truth == (violated ? Truth::False : Truth::True));
    }
  }
  CHECK(models > 12);
}

TEST_CASE("The answers to an example do not depend on any one of the reductions") {
  auto [folder, root] = GENERATE(table<std::string, std::string>({{"drone", "drone.proskill"},
                                                                  {"rover", "rover.proskill"},
                                                                  {"arm", "arm.proskill"},
                                                                  {"lift", "lift.proskill"},
                                                                  {"lift", "timed.proskill"}}));
  const codegen::Model model = example(folder, root);
  const verify::Result expected = answers(model, {});
  for (const auto& answer : expected.answers) CHECK(answer.truth != Truth::Unknown);
  for (auto reduction : verify::Options{}.reductions) {
    verify::Options options;
    options.reductions.erase(reduction);
    auto result = answers(model, options);
    for (std::size_t i = 0; i < expected.answers.size(); ++i) {
      INFO(root << ": " << model.fiacre.properties[i].name << " without reduction "
                << static_cast<int>(reduction));
      CHECK(result.answers[i].truth == expected.answers[i].truth);
    }
  }
}

TEST_CASE(
    "What an exploration without reductions decides of an example is what one with them decides") {
  const codegen::Model model = example("drone", "drone.proskill");
  const verify::Result expected = answers(model, {});
  verify::Options options;
  options.reductions.clear();
  options.limits.classes = 300'000;
  auto result = answers(model, options);
  for (std::size_t i = 0; i < expected.answers.size(); ++i) {
    INFO(model.fiacre.properties[i].name);
    const auto& answer = result.answers[i];
    CHECK((answer.truth == Truth::Unknown || answer.truth == expected.answers[i].truth));
  }
}

TEST_CASE("Every answer of the drone is decided, and every one that is false has a trace") {
  auto result = answers(example("drone", "drone.proskill"), {});
  for (const auto& answer : result.answers) {
    CHECK(answer.truth != Truth::Unknown);
    CHECK((answer.truth == Truth::False) == answer.trace.has_value());
  }
  CHECK(result.exploration.markings < 100'000);
}
