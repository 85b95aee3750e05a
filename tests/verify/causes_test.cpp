#include "tests/support/memory_files.h"
#include "tests/support/models.h"
#include "tests/support/random/random_model.h"
#include "tests/support/random/random_program.h"
#include "tests/support/texts.h"
#include "verify/trace/causes.h"

#include "codegen/model.h"
#include "tests/where.h"
#include "verify/compile/compile.h"
#include "verify/state/state_layout.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <numeric>
#include <sstream>

using namespace proskill;
using namespace proskill::test;

namespace {

verify::Trace traceOf(const Model& model, fiacre::Property property) {
  auto answer = model.answer(std::move(property));
  REQUIRE(answer.truth == verify::Truth::False);
  return answer.trace.value();
}

/// The first transition of each relevant step.
std::vector<std::string> relevantOf(const verify::Trace& trace) {
  std::vector<std::string> names;
  for (const auto& step : trace.steps)
    if (step.relevant) names.push_back(step.transitions.at(0));
  return names;
}

using Names = std::vector<std::string>;

/// Number of traces, and how many were shortened.
struct Tally {
  std::size_t traces = 0;
  std::size_t shorter = 0;
};

/// Answers all questions, and tests the slice of each trace with `reproduces`. The engine tests it,
/// too, but falls back on all steps.
Tally tryAll(const fiacre::Program& program, const fiacre::Provenance& provenance) {
  Tally tally;
  std::vector<verify::Question> questions(program.properties.size());
  for (std::size_t i = 0; i < questions.size(); ++i) questions[i].property = i;
  verify::Options options;
  options.limits.classes = 20'000;
  verify::LimitWatch limits(options);
  const auto compiled = verify::compile(program, provenance, questions, &limits);
  if (!compiled) return tally;
  const auto system = verify::withStateLayout(compiled->system);
  const verify::Enabling enabling(system);
  const auto found = verify::search(system, compiled->goals, {}, verify::Extrapolation::Least,
                                    limits, [](std::size_t, const verify::Evidence&) {});
  for (std::size_t i = 0; i < found.goals.size(); ++i) {
    if (!found.goals[i]) continue;
    const auto& goal = compiled->goals[i];
    const auto causes =
        verify::causesOf(system, enabling, provenance, goal, *found.goals[i], limits);
    INFO("property " << program.properties[i].name);
    CHECK(verify::reproduces(system, goal, *found.goals[i], causes.relevant));
    ++tally.traces;
    if (std::ranges::count(causes.relevant, false) > 0) ++tally.shorter;
  }
  return tally;
}

codegen::Model exampleModel(const std::string& folder, const std::string& root) {
  std::map<std::string, std::string> texts;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(PROSKILL_SOURCE_DIR) / "examples" / folder)) {
    std::stringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    texts[entry.path().filename()] = text.str();
  }
  auto model = codegen::generate(analysis::load(MemoryFiles(texts), root));
  REQUIRE(model.has_value());
  return std::move(*model);
}

} // namespace

TEST_CASE("what another process does beside it does not matter") {
  Model model;
  model.variable("seen", boolean(), truth(false));
  model.variable("other", range(0, 3), number(0));
  model.add(process("beside", {"a", "b"},
                    {from("a", {now(), assign(name("other"), number(2)), to("b")})}));
  model.add(process("sees", {"a", "b"},
                    {from("a", {wait(1, 1), assign(name("seen"), truth(true)), to("b")})}));
  model.add(process("reads", {"a", "b"}, {from("a", {wait(0, 1), on(name("seen")), to("b")})}));
  const auto trace = traceOf(model, absentState(3, "b"));
  REQUIRE(trace.steps.size() == 3);
  CHECK(relevantOf(trace) == Names{"sees_1_t0", "reads_1_t0"});
  CHECK(trace.steps[2].causes == std::vector<std::size_t>{1});
}

TEST_CASE("of a disjunction that is true one operand suffices") {
  Model model;
  model.variable("x", boolean(), truth(false));
  model.variable("y", boolean(), truth(true));
  model.add(
      process("sets", {"a", "b"}, {from("a", {now(), assign(name("x"), truth(true)), to("b")})}));
  model.add(process(
      "reads", {"a", "b"},
      {from("a", {wait(1, 1), on(binary(fiacre::Op::Or, name("x"), name("y"))), to("b")})}));
  const auto trace = traceOf(model, absentState(2, "b"));
  CHECK(relevantOf(trace) == Names{"reads_1_t0"});
}

TEST_CASE("a step that had to wait depends on the step that started its clock") {
  Model model;
  model.variable("go", boolean(), truth(false));
  model.add(process("starts", {"a", "b"},
                    {from("a", {wait(2, 2), assign(name("go"), truth(true)), to("b")})}));
  model.add(process("waits", {"a", "b"}, {from("a", {on(name("go")), wait(3, 3), to("b")})}));
  const auto trace = traceOf(model, absentState(2, "b"));
  REQUIRE(trace.steps.size() == 2);
  REQUIRE(trace.steps[1].timer.has_value());
  CHECK(trace.steps[1].timer->since == 1);
  CHECK(trace.steps[1].causes == std::vector<std::size_t>{0});
}

TEST_CASE("what a step overwrites does not matter, and what it adds to does") {
  Model model;
  model.variable("x", range(0, 9), number(0));
  model.add(process("p", {"a", "b", "c", "d"},
                    {from("a", {now(), assign(name("x"), number(5)), to("b")}),
                     from("b", {now(), assign(name("x"), sum(name("x"), number(1))), to("c")}),
                     from("c", {now(), assign(name("x"), sum(name("x"), number(1))), to("d")})}));
  // the order of its steps is that of one process: each needs the previous one
  CHECK(relevantOf(traceOf(model, absentValue(equals(name("x"), number(7))))).size() == 3);

  Model apart;
  apart.variable("x", range(0, 9), number(0));
  apart.add(
      process("first", {"a", "b"}, {from("a", {now(), assign(name("x"), number(5)), to("b")})}));
  apart.add(process("second", {"a", "b"},
                    {from("a", {wait(1, 1), assign(name("x"), number(7)), to("b")})}));
  CHECK(relevantOf(traceOf(apart, absentValue(equals(name("x"), number(7))))) ==
        Names{"second_1_t0"});
}

TEST_CASE("where nothing is possible any more, all that stopped matters") {
  Model model;
  model.variable("noise", range(0, 3), number(0));
  model.add(process("p", {"a", "b"}, {from("a", {wait(1, 1), to("b")})}));
  model.add(process("q", {"a", "b"},
                    {from("a", {wait(1, 1), assign(name("noise"), number(1)), to("b")})}));
  const auto trace = traceOf(model, plain(fiacre::PatternKind::DeadlockFree));
  CHECK(relevantOf(trace).size() == 2);
}

TEST_CASE("the relevant steps alone come to the same, in every example") {
  Tally all;
  const auto add = [&](Tally more) {
    all.traces += more.traces;
    all.shorter += more.shorter;
  };
  for (const auto& [folder, root] : {std::pair{"rover", "bug.proskill"},
                                     {"rover", "rover.proskill"},
                                     {"lift", "bug.proskill"},
                                     {"arm", "bug.proskill"},
                                     {"drone", "drone.proskill"}}) {
    const auto model = exampleModel(folder, root);
    add(tryAll(model.fiacre, model.provenance));
  }
  CHECK(all.traces > 100);
  CHECK(all.shorter > all.traces / 4);
}

TEST_CASE("the relevant steps alone come to the same, in random models") {
  Tally all;
  const auto add = [&](Tally more) {
    all.traces += more.traces;
    all.shorter += more.shorter;
  };
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    add(tryAll(randomModel(seed), {}));
    add(tryAll(randomModelWithData(seed), {}));
    add(tryAll(randomModelWithObserver(seed), {}));
  }
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto text = textOf(randomProgram(seed, varied(seed)));
    const auto model = codegen::generate(programOfText(text));
    INFO(text);
    REQUIRE(model.has_value());
    add(tryAll(model->fiacre, model->provenance));
  }
  CHECK(all.traces > 500);
  CHECK(all.shorter > 100);
}
