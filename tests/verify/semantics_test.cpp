#include "tests/support/models.h"

#include <catch2/catch.hpp>

using namespace proskill;
using namespace proskill::test;

namespace {

using fiacre::PatternKind;

/// A process that goes from `a` to `b` with this statement before `to b`.
fiacre::Process once(std::string text, std::vector<fiacre::Statement> statements) {
  statements.push_back(to("b"));
  return process(std::move(text), {"a", "b"}, {from("a", std::move(statements))});
}

} // namespace

TEST_CASE("A state is reachable where a path leads to it, and not where its guard is never true") {
  Model model;
  model.variable("x", range(0, 3), number(1));
  model.add(once("go", {on(equals(name("x"), number(1)))}));
  model.add(once("stay", {on(equals(name("x"), number(2)))}));
  CHECK(model.reaches(1, "b"));
  CHECK_FALSE(model.reaches(2, "b"));
}

TEST_CASE("A path is one step: nobody sees what it assigns on the way") {
  Model model;
  model.variable("x", range(0, 3), number(0));
  model.add(once("writer", {assign(name("x"), number(1)), assign(name("x"), number(2))}));
  model.add(
      process("reader", {"a", "saw1", "saw2"},
              {from("a", {select({sequence({on(equals(name("x"), number(1))), to("saw1")}),
                                  sequence({on(equals(name("x"), number(2))), to("saw2")})})})}));
  CHECK_FALSE(model.reaches(2, "saw1"));
  CHECK(model.reaches(2, "saw2"));
}

TEST_CASE("Several targets are assigned at once") {
  Model model;
  model.variable("x", range(0, 3), number(1)).variable("y", range(0, 3), number(2));
  fiacre::Statement swap{.kind = fiacre::StatementKind::Assign,
                         .targets = {name("x"), name("y")},
                         .values = {name("y"), name("x")}};
  model.add(once("swap", {swap}));
  CHECK(model.isFalse(absentValue(
      binary(fiacre::Op::And, equals(name("x"), number(2)), equals(name("y"), number(1))))));
}

TEST_CASE("A guard after an assignment sees the new value") {
  Model model;
  model.variable("x", range(0, 3), number(1));
  model.add(once("first",
                 {assign(name("x"), sum(name("x"), number(1))), on(equals(name("x"), number(2)))}));
  CHECK(model.reaches(1, "b"));
  CHECK(model.isFalse(absentValue(equals(name("x"), number(2)))));
  CHECK_FALSE(model.isFalse(absentValue(equals(name("x"), number(3)))));
}

TEST_CASE("A choice without waits is part of a step, with targets of its own") {
  Model model;
  model.variable("x", range(0, 1), number(0));
  model.add(process("p", {"a", "b", "c"},
                    {from("a", {now(), ifElse(equals(name("x"), number(0)), to("b"), to("c"))})}));
  CHECK(model.reaches(1, "b"));
  CHECK_FALSE(model.reaches(1, "c"));
}

TEST_CASE("What is urgent comes before any time") {
  Model model;
  model.add(process(
      "p", {"a", "soon", "late"},
      {from("a", {select({sequence({now(), to("soon")}), sequence({wait(1, 2), to("late")})})})}));
  CHECK(model.reaches(1, "soon"));
  CHECK_FALSE(model.reaches(1, "late"));
}

TEST_CASE("An upper bound forces: the slower of two never comes") {
  const auto race = [](fiacre::Interval first, fiacre::Interval second) {
    Model model;
    model.add(process("p", {"a", "x", "y"},
                      {from("a", {select({sequence({waitIn(first), to("x")}),
                                          sequence({waitIn(second), to("y")})})})}));
    return std::pair(model.reaches(1, "x"), model.reaches(1, "y"));
  };
  CHECK(race({1, 2}, {3, 4}) == std::pair(true, false));
  CHECK(race({1, 3}, {3, 4}) == std::pair(true, true));
  CHECK(race({1, 3, false, true}, {3, 4}) == std::pair(true, false));
  CHECK(race({1, 3}, {3, 4, true, false}) == std::pair(true, false));
  CHECK(race({2, 2}, {0, std::nullopt}) == std::pair(true, true));
}

TEST_CASE("`loop` leaves the other clocks alone, `to` starts them anew") {
  const auto blinker = [](fiacre::Statement end) {
    Model model;
    model.add(process("p", {"a", "b"},
                      {from("a", {select({sequence({wait(1, 1), std::move(end)}),
                                          sequence({wait(3, 3), to("b")})})})}));
    return model.reaches(1, "b");
  };
  CHECK(blinker(loop()));
  CHECK_FALSE(blinker(to("a")));
}

TEST_CASE("A transition that is disabled for a moment starts its clock anew") {
  Model model;
  model.variable("on", boolean(), truth(true));
  model.add(process("timer", {"a", "b"}, {from("a", {wait(3, 3), on(name("on")), to("b")})}));
  model.add(process("toggle", {"a", "b", "c", "d"},
                    {from("a", {wait(2, 2), assign(name("on"), truth(false)), to("b")}),
                     from("b", {now(), assign(name("on"), truth(true)), to("c")}),
                     from("c", {wait(2, 2), to("d")}), from("d", {wait(1, 1), to("d")})}));
  CHECK(model.reaches(1, "b"));
  Model both = model;
  both.add(process("clock", {"a", "at3", "at4"},
                   {from("a", {wait(3, 3), to("at3")}), from("at3", {wait(1, 1), to("at4")})}));
  const auto seen = [](std::uint32_t place, std::string state) {
    return fiacre::Observable{
        .kind = fiacre::ObservableKind::State, .path = {place}, .name = state};
  };
  fiacre::Observable early{.kind = fiacre::ObservableKind::And,
                           .operands = {seen(1, "b"), seen(3, "a")}};
  fiacre::Observable right{.kind = fiacre::ObservableKind::And,
                           .operands = {seen(1, "b"), seen(3, "at4")}};
  fiacre::Observable at3{.kind = fiacre::ObservableKind::And,
                         .operands = {seen(1, "b"), seen(3, "at3")}};
  const auto absent = [](fiacre::Observable what) {
    return fiacre::Property{.pattern = {.kind = PatternKind::Absent, .operands = {what}}};
  };
  CHECK_FALSE(both.isFalse(absent(early)));
  CHECK_FALSE(both.isFalse(absent(at3)));
  CHECK(both.isFalse(absent(right)));
}

TEST_CASE("A port waits for all who have it, and then for its interval") {
  Model model;
  model.channel("p", fiacre::Interval{2, 2});
  model.add(process("left", {"a", "b"}, {from("a", {port("p"), to("b")})}));
  model.add(process("right", {"w", "a", "b"},
                    {from("w", {wait(3, 3), to("a")}), from("a", {port("p"), to("b")})}));
  model.add(process("clock", {"a", "b", "c"},
                    {from("a", {wait(4, 4), to("b")}), from("b", {wait(2, 2), to("c")})}));
  const auto together = [](std::string clock) {
    const auto seen = [](std::uint32_t place, std::string state) {
      return fiacre::Observable{
          .kind = fiacre::ObservableKind::State, .path = {place}, .name = std::move(state)};
    };
    fiacre::Observable both{.kind = fiacre::ObservableKind::And,
                            .operands = {seen(1, "b"), seen(3, std::move(clock))}};
    return fiacre::Property{.pattern = {.kind = PatternKind::Absent, .operands = {both}}};
  };
  CHECK_FALSE(model.isFalse(together("a")));
  CHECK(model.isFalse(together("b")));
}

TEST_CASE("A part of a synchronisation does not see what another assigns in it") {
  Model model;
  model.variable("x", range(0, 1), number(0)).variable("y", range(0, 1), number(0)).channel("p");
  model.add(once("left", {port("p"), assign(name("x"), number(1))}));
  model.add(once("right", {port("p"), assign(name("y"), name("x"))}));
  CHECK(model.isFalse(absentValue(equals(name("x"), number(1)))));
  CHECK_FALSE(model.isFalse(absentValue(equals(name("y"), number(1)))));
}

TEST_CASE("A model stops where nothing is possible any more") {
  Model model;
  model.add(once("p", {}));
  CHECK(model.stops());
  Model runs;
  runs.add(process("p", {"a"}, {from("a", {wait(1, 2), to("a")})}));
  CHECK_FALSE(runs.stops());
}

TEST_CASE("A value out of range is an error of the model, not a step") {
  Model model;
  model.variable("x", range(0, 1), number(1));
  model.add(once("p", {assign(name("x"), sum(name("x"), number(1)))}));
  CHECK_THROWS_WITH(model.answer(absentState(1, "b")), Catch::Contains("outside of 0..1"));
}
