#include "tests/syntax/programs.h"

#include <catch2/catch.hpp>

using namespace proskill;

TEST_CASE("the paper's listings are accepted exactly as printed") {
  for (auto listing : {test::kPaperStateVariables, test::kPaperEvent, test::kPaperBasicSkill,
                       test::kPaperCompositeSkill, test::kPaperMonitor}) {
    INFO(listing);
    CHECK(test::codesOf(syntax::Document::parse(std::string(listing))) == "");
  }
}

TEST_CASE("the examples have nothing wrong with their form") {
  auto programs = test::allPrograms();
  REQUIRE(programs.size() > 5);
  for (const auto& program : programs) {
    INFO(program);
    CHECK(test::codesOf(syntax::Document::parse(program)) == "");
  }
}

TEST_CASE("the state variables of the paper") {
  auto document = syntax::Document::parse(std::string(test::kPaperStateVariables));
  REQUIRE(document.forms().size() == 2);

  const auto& levels = std::get<syntax::StateVariable>(document.forms()[0].node());
  CHECK(levels.name.text == "flight_levels");
  CHECK(levels.isNatural());
  CHECK(levels.init.number == syntax::Rational{1});
  CHECK(levels.max->number == syntax::Rational{3});

  const auto& battery = std::get<syntax::StateVariable>(document.forms()[1].node());
  CHECK_FALSE(battery.isNatural());
  REQUIRE(battery.states.size() == 3);
  CHECK(battery.states[2].text == "Critical");
  CHECK(battery.init.name.text == "Good");
  CHECK(battery.transitionsKind == syntax::Transitions::Listed);
  REQUIRE(battery.transitions.size() == 4);
  CHECK(battery.transitions[2].from.text == "Critical");
  CHECK(battery.transitions[2].to.text == "Low");
}

TEST_CASE("the basic skill of the paper") {
  auto document = syntax::Document::parse(std::string(test::kPaperBasicSkill));
  const auto& takeoff = std::get<syntax::Skill>(document.forms().at(0).node());
  CHECK_FALSE(takeoff.isComposite());
  REQUIRE(takeoff.inputs.size() == 2);
  CHECK(takeoff.inputs[1].name.text == "$duration");
  CHECK(takeoff.inputs[1].type.text == "float");
  REQUIRE(takeoff.preconditions.size() == 4);
  CHECK(takeoff.preconditions[3].tag.text == "origin_valid");
  CHECK(takeoff.preconditions[3].condition.operands.at(0).name.text == "Valid");
  CHECK(takeoff.start.items.at(0).value.name.text == "Controlled");
  REQUIRE(takeoff.invariants.size() == 2);
  CHECK(takeoff.invariants[0].effects.items.empty());
  CHECK(takeoff.invariants[1].guard.kind == syntax::ExprKind::Not);
  CHECK(takeoff.invariants[1].effects.items.size() == 1);
  CHECK(takeoff.timeInterval->lower == syntax::Rational{1});
  CHECK(takeoff.timeInterval->upper == syntax::Rational{3});
  CHECK(takeoff.action->command.text == "takeoff");
  CHECK(takeoff.interrupt->effects.items.size() == 1);
  REQUIRE(takeoff.successes.size() == 1);
  CHECK(takeoff.successes[0].tag.text == "at_altitude");
  CHECK(takeoff.successes[0].postcondition->kind == syntax::ExprKind::Test);
  REQUIRE(takeoff.failures.size() == 2);
  CHECK(takeoff.failures[1].tag.text == "emergency");
}

TEST_CASE("the composite skill of the paper") {
  using syntax::StatementKind;
  auto document = syntax::Document::parse(std::string(test::kPaperCompositeSkill));
  const auto& mission = std::get<syntax::Skill>(document.forms().at(0).node());
  CHECK(mission.timeInterval->upper == syntax::Rational{120});
  CHECK(mission.successes.at(0).tag.text == "mission_accomplished");
  REQUIRE(mission.body);
  const auto& body = mission.body->statements;
  REQUIRE(body.size() == 6);
  CHECK(body[1].kind == StatementKind::WaitCondition);
  CHECK(body[2].arguments.at(0).name.text == "height");
  CHECK(body[2].arguments.at(0).value.number == syntax::Rational{3});
  CHECK(body[2].arguments.at(0).value.decimal);
  CHECK(body[5].kind == StatementKind::Failure);

  const auto& branching = body[3];
  REQUIRE(branching.arms.size() == 1);
  const auto& parallel = branching.arms[0].body.statements.at(0);
  REQUIRE(parallel.branches.size() == 2);
  const auto& second = parallel.branches[1].statements;
  REQUIRE(second.size() == 4);
  CHECK(second[1].kind == StatementKind::WaitTime);
  CHECK(second[2].arguments.at(0).value.number == syntax::Rational{-3});
  CHECK(second[3].kind == StatementKind::Interrupt);
  CHECK(second[3].name.text == "camera_survey");
}

TEST_CASE("the monitor of the paper") {
  auto document = syntax::Document::parse(std::string(test::kPaperMonitor));
  const auto& monitor = std::get<syntax::Skill>(document.forms().at(0).node());
  CHECK(monitor.monitor);
  CHECK(monitor.body->statements.at(1).format.text == "We will try to land the drone safely...");
  CHECK(monitor.body->statements.at(2).arguments.at(2).value.number == syntax::Rational{-1, 10});
}
