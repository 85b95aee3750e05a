#include "tests/support/models.h"

#include <catch2/catch.hpp>

namespace proskill::test::progress_test {

using namespace proskill::test;

namespace {

const fiacre::Property kProgress = plain(fiacre::PatternKind::Progress);

Model oneProcess(std::vector<std::string> states, std::vector<fiacre::From> transitions) {
  Model model;
  model.add(process("p", std::move(states), std::move(transitions)));
  return model;
}

} // namespace

TEST_CASE("Time goes on where every chain of urgent steps ends") {
  CHECK_FALSE(
      oneProcess({"a", "b"}, {from("a", {now(), to("b")}), from("b", {wait(1, 1), to("a")})})
          .isFalse(kProgress));
}

TEST_CASE("A cycle of urgent steps stops time") {
  auto model = oneProcess({"a", "b"}, {from("a", {now(), to("b")}), from("b", {now(), to("a")})});
  CHECK(model.isFalse(kProgress));
}

TEST_CASE("A cycle of urgent steps that can be left does not stop time") {
  auto model = oneProcess({"a", "b"}, {from("a", {now(), select({to("b"), to("a")})})});
  CHECK_FALSE(model.isFalse(kProgress));
}

TEST_CASE("That time stops is shown where more is possible than a replay can go through") {
  std::vector<std::string> states;
  std::vector<fiacre::From> transitions;
  for (int i = 0; i < 30; ++i) states.push_back("s" + std::to_string(i));
  for (int i = 0; i < 30; ++i)
    transitions.push_back(from(states[i], {now(), to(states[(i + 1) % 30])}));
  Model model;
  for (const char* name : {"p", "q", "r"}) model.add(process(name, states, transitions));
  CHECK(model.isFalse(kProgress));
}

TEST_CASE("A deadlock does not stop time") {
  CHECK_FALSE(oneProcess({"a", "b"}, {from("a", {to("b")})}).isFalse(kProgress));
}

TEST_CASE("Time may stop only where a clock has come to its upper bound") {
  const auto model = [](fiacre::Interval window) {
    Model made;
    made.variable("trap", boolean(), truth(false));
    made.add(process("setter", {"a", "b"},
                     {from("a", {wait(2, 2), assign(name("trap"), truth(true)), to("b")})}));
    made.add(process("p", {"a", "out", "in"},
                     {from("a", {waitIn(window), ifElse(name("trap"), to("in"), to("out"))}),
                      from("in", {now(), to("in")})}));
    return made;
  };
  CHECK(model({1, 3}).isFalse(kProgress));
  CHECK(model({1, 2}).isFalse(kProgress));
  CHECK_FALSE(model({0, 1}).isFalse(kProgress));
  CHECK_FALSE(model({1, 2, false, true}).isFalse(kProgress));
}

TEST_CASE("That time stops is shown by a trace") {
  Model model;
  model.add(
      process("p", {"a", "b"}, {from("a", {wait(3, 5), to("b")}), from("b", {now(), to("b")})}));
  auto answer = model.answer(kProgress);
  REQUIRE(answer.trace.has_value());
  REQUIRE_FALSE(answer.trace->steps.empty());
  CHECK(answer.trace->steps[0].earliest.value == 3);
}

TEST_CASE("What need not happen does not help time on") {
  const auto model = [](fiacre::Interval window) {
    Model made;
    made.variable("way", boolean(), truth(false));
    made.add(process("p", {"a", "b"},
                     {from("a", {now(), on(equals(name("way"), truth(false))), to("a")})}));
    made.add(process("helper", {"a", "b"},
                     {from("a", {waitIn(window), assign(name("way"), truth(true)), to("b")})}));
    return made;
  };
  CHECK(model({}).isFalse(kProgress));
  CHECK(model({0, 2}).isFalse(kProgress));
  CHECK_FALSE(model({0, 0}).isFalse(kProgress));
}

TEST_CASE("Whether a ring of urgent steps is left may depend on inputs that several places read") {
  using Exit = std::pair<int, decltype(truth(true))>;
  const auto model = [](const std::vector<Exit>& exits) {
    Model made;
    for (const char* input : {"v", "w"}) {
      made.variable(input, range(0, 2), number(0));
      std::vector<fiacre::Statement> values;
      for (std::int64_t value = 0; value < 3; ++value)
        values.push_back(sequence({assign(name(input), number(value)), to("a")}));
      made.add(process(std::string("sets_") + input, {"a"}, {from("a", {select(values)})}));
    }
    std::vector<std::string> states{"start", "out"};
    for (int i = 0; i < 6; ++i) states.push_back("s" + std::to_string(i));
    std::vector<fiacre::Statement> entries;
    std::vector<fiacre::From> steps;
    for (int i = 0; i < 6; ++i) {
      const auto next = to("s" + std::to_string((i + 1) % 6));
      entries.push_back(to("s" + std::to_string(i)));
      std::vector<fiacre::Statement> ways{next};
      for (const auto& [at, condition] : exits)
        if (at == i) ways.push_back(sequence({on(condition), to("out")}));
      steps.push_back(from("s" + std::to_string(i), {now(), select(ways)}));
    }
    steps.push_back(from("start", {wait(1, 2), select(entries)}));
    made.add(process("p", states, steps));
    return made;
  };
  const auto is = [](const char* input, int value) { return equals(name(input), number(value)); };
  const auto isNot = [&](const char* input, int value) {
    return unary(fiacre::Op::Not, is(input, value));
  };
  CHECK(model({{3, is("w", 2)}}).isFalse(kProgress));
  CHECK(model({{3, is("w", 2)}, {5, is("v", 1)}}).isFalse(kProgress));
  CHECK_FALSE(model({{3, is("w", 2)}, {5, isNot("w", 2)}}).isFalse(kProgress));
  CHECK_FALSE(model({{3, is("w", 2)}, {5, is("v", 1)}, {0, isNot("v", 1)}}).isFalse(kProgress));
}

} // namespace proskill::test::progress_test
