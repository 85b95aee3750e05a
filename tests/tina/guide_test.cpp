#include "tests/support/random/random_model.h"
#include "tina/graph_text.h"
#include "tina/guide.h"
#include "verify/graph/state_graph.h"

#include "fiacre/print/print.h"

#include <catch2/catch.hpp>

#include <sstream>

namespace proskill::test::guide_test {

using verify::Truth;

namespace {

std::vector<verify::Question> allOf(const fiacre::Program& program) {
  std::vector<verify::Question> questions;
  for (std::size_t i = 0; i < program.properties.size(); ++i) questions.push_back({i});
  return questions;
}

/// The graph of a model as ktzio would write it, read back; nullopt if it is large.
std::optional<tina::KtzGraph> graphOf(const fiacre::Program& program) {
  verify::Options options;
  options.limits.classes = 3000;
  const auto graph = verify::stateGraph(program, verify::GraphKind::Classes, options);
  if (!graph || !graph->counts.complete) return std::nullopt;
  std::stringstream text;
  tina::writeKtzText(text, *graph, "main");
  auto read = tina::readKtzText(text);
  if (!read) FAIL(read.error());
  return std::move(*read);
}

std::vector<std::string> transitionsOf(const verify::Trace& trace) {
  std::vector<std::string> names;
  for (const auto& step : trace.steps) names.push_back(step.transitions.at(0));
  return names;
}

} // namespace

TEST_CASE("traces of random models are followed by their names alone, and found in their graphs") {
  std::size_t followed = 0;
  std::size_t absent = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const auto program = test::randomModel(seed);
    const auto questions = allOf(program);
    const auto graph = graphOf(program);
    const auto result = verify::verify(program, {}, questions);
    if (!graph || !result) continue;
    const fiacre::Provenance provenance;
    auto guide = tina::Guide::make(program, provenance, questions);
    REQUIRE(guide.has_value());
    for (std::size_t i = 0; i < questions.size(); ++i) {
      INFO("seed " << seed << ", property " << i << "\n" << fiacre::print(program));
      const auto& answer = result->answers[i];
      if (!(*guide)->judges(i) || answer.truth == Truth::Unknown) continue;
      const auto searched = (*guide)->search(i, *graph);
      if (!searched) FAIL(searched.error());
      CHECK(searched->has_value() == (answer.truth == Truth::False));
      if (answer.truth == Truth::True) {
        ++absent;
        continue;
      }
      const auto names = transitionsOf(*answer.trace);
      const auto again = (*guide)->follow(i, names);
      if (!again) FAIL(again.error());
      CHECK(again->steps.size() <= names.size());
      ++followed;
    }
  }
  CHECK(followed > 150);
  CHECK(absent > 100);
}

} // namespace proskill::test::guide_test
