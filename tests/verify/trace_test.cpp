#include "tests/support/models.h"

#include <catch2/catch.hpp>

using namespace proskill;
using namespace proskill::test;

namespace {

verify::Trace traceTo(const Model& model, std::uint32_t place, std::string state) {
  auto answer = model.answer(absentState(place, std::move(state)));
  REQUIRE(answer.truth == verify::Truth::False);
  REQUIRE(answer.trace.has_value());
  return *answer.trace;
}

fiacre::Statement from7(fiacre::Statement statement) {
  statement.origin = 7;
  return statement;
}

} // namespace

TEST_CASE(
    "A trace names its transitions as frac does, the later member of a synchronisation first") {
  Model model;
  model.channel("p");
  model.add(process(
      "first", {"a", "b"},
      {from("a", {select({sequence({wait(1, 1), to("a")}), sequence({port("p"), to("b")})})})}));
  model.add(process("second", {"a", "b"}, {from("a", {port("p"), to("b")})}));
  auto trace = traceTo(model, 2, "b");
  REQUIRE(trace.steps.size() == 1);
  CHECK(trace.steps[0].transitions == std::vector<std::string>{"second_1_t0_first_1_t1"});
}

TEST_CASE("Each branch of an `if` that ends has a number of its own") {
  Model model;
  model.variable("x", range(0, 1), number(1));
  model.add(process("p", {"a", "b", "c"},
                    {from("a", {now(), ifElse(equals(name("x"), number(0)), to("b"), to("c"))})}));
  CHECK(traceTo(model, 1, "c").steps.at(0).transitions.at(0) == "p_1_t1");
}

TEST_CASE("A step has its earliest and latest date over all runs, and one in a run") {
  Model model;
  model.add(process("p", {"a", "b", "c"},
                    {from("a", {wait(1, 3), to("b")}), from("b", {wait(2, 4), to("c")})}));
  auto trace = traceTo(model, 1, "c");
  REQUIRE(trace.steps.size() == 2);
  CHECK(trace.steps[0].earliest.value == 1);
  CHECK(trace.steps[0].latest.value().value == 3);
  CHECK(trace.steps[1].earliest.value == 3);
  CHECK(trace.steps[1].latest.value().value == 7);
  CHECK(trace.scale == 1);
  CHECK(trace.steps[1].date == 3);
}

TEST_CASE("What others have to do bounds the dates of a step") {
  Model model;
  model.add(process("free", {"a", "b"}, {from("a", {always(), to("b")})}));
  model.add(process("bound", {"a", "b"}, {from("a", {wait(5, 5), to("b")})}));
  auto trace = traceTo(model, 1, "b");
  REQUIRE(trace.steps.size() == 1);
  CHECK(trace.steps[0].earliest.value == 0);
  CHECK(trace.steps[0].latest.value().value == 5);
}

TEST_CASE("Strict bounds are met by dates in fractions of the unit") {
  Model model;
  model.add(process("p", {"a", "b"}, {from("a", {waitIn({2, 3, true, true}), to("b")})}));
  auto trace = traceTo(model, 1, "b");
  CHECK(trace.steps[0].earliest.strict);
  CHECK(trace.steps[0].earliest.value == 2);
  CHECK(trace.steps[0].latest.value().strict);
  CHECK(trace.steps[0].date > 2 * trace.scale);
  CHECK(trace.steps[0].date < 3 * trace.scale);
}

TEST_CASE("A step without an upper bound has no latest date") {
  Model model;
  model.add(process("p", {"a", "b"}, {from("a", {wait(4, std::nullopt), to("b")})}));
  auto trace = traceTo(model, 1, "b");
  CHECK(trace.steps[0].earliest.value == 4);
  CHECK_FALSE(trace.steps[0].latest.has_value());
}

TEST_CASE("A trace tells the variables that a user knows, before and after, in words") {
  Model model;
  model.variable("lamp", unionOf({"Off", "On"}), name("Off"));
  model.add(
      process("p", {"a", "b"}, {from("a", {from7(assign(name("lamp"), name("On"))), to("b")})}));
  model.ask(absentState(1, "b"));
  fiacre::Provenance provenance;
  provenance.origins.resize(8);
  provenance.watched = {{"lamp", "the lamp"}};
  auto result = verify::verify(model.program(), provenance, {{0}});
  REQUIRE(result.has_value());
  const auto& trace = result->answers[0].trace.value();
  REQUIRE(trace.initial.size() == 1);
  CHECK(trace.initial[0].variable == "the lamp");
  CHECK(trace.initial[0].after == "Off");
  REQUIRE(trace.steps[0].changes.size() == 1);
  CHECK(trace.steps[0].changes[0].before == "Off");
  CHECK(trace.steps[0].changes[0].after == "On");
  CHECK(trace.steps[0].origins == std::vector<fiacre::OriginId>{7});
}

TEST_CASE("Processes that an exploration leaves out take their steps in the trace") {
  Model model;
  model.variable("alarm", boolean(), truth(false));
  model.add(process("watcher", {"calm", "alarmed"},
                    {from("calm", {now(), on(name("alarm")), to("alarmed")})}));
  model.add(process("p", {"a", "b", "c"},
                    {from("a", {wait(1, 1), assign(name("alarm"), truth(true)), to("b")}),
                     from("b", {wait(1, 1), to("c")})}));
  auto trace = traceTo(model, 2, "c");
  REQUIRE(trace.steps.size() == 3);
  CHECK(trace.steps[1].transitions.at(0) == "watcher_1_t0");
  CHECK(trace.steps[1].date == trace.steps[0].date);
}

TEST_CASE("A trace that nobody looks at is not made, and the answer is the same") {
  Model model;
  model.add(process("p", {"a", "b", "c"},
                    {from("a", {wait(1, 1), to("b")}), from("b", {wait(1, 1), to("c")})}));
  for (const auto* state : {"b", "c", "a"}) model.ask(absentState(1, state));
  model.ask(plain(fiacre::PatternKind::DeadlockFree));
  for (auto options : reductionChoices()) {
    options.wantsTrace = [](std::size_t question) { return question == 1; };
    const auto answers = model.answers(options).answers;
    REQUIRE(answers.size() == 4);
    for (const auto& answer : answers) CHECK(answer.truth == verify::Truth::False);
    CHECK_FALSE(answers[0].trace.has_value());
    CHECK(answers[1].trace.value().steps.size() == 2);
    CHECK_FALSE(answers[2].trace.has_value());
    CHECK_FALSE(answers[3].trace.has_value());
  }
}

TEST_CASE("A trace to the initial state has no steps") {
  Model model;
  model.add(process("p", {"a"}, {from("a", {wait(1, 1), to("a")})}));
  CHECK(traceTo(model, 1, "a").steps.empty());
}
