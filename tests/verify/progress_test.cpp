#include "tests/support/models.h"

#include <catch2/catch.hpp>

using namespace proskill;
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
