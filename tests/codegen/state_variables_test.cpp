#include "tests/codegen/model_of.h"

#include <catch2/catch.hpp>

using namespace proskill;
using Catch::Contains;

namespace {

constexpr auto kBattery = R"(
  (defsv battery :states (Good Low Critical) :init Low
    :transitions ((Good Low) (Low Critical) (Critical Low) (Low Good)))
  (defevent to_critical :effects (battery Critical))
  (defevent to_low :effects (battery Low)))";

std::string eventState(const std::string& program, const std::string& event) {
  return test::printedState(test::modelOf(program), "event_" + event + "_automata", "start_");
}

} // namespace

TEST_CASE("a move is tested where some move to the value is forbidden, and nowhere else") {
  CHECK(eventState(kBattery, "to_critical") == R"(from start_
    to_critical;
    if (battery = Good) then
        #battery_forbidden
    end;
    battery := Critical;
    to start_
)");
  CHECK(eventState(kBattery, "to_low") == R"(from start_
    to_low;
    battery := Low;
    to start_
)");
}

TEST_CASE("in the expanded edition the exact automaton goes to error when the alarm is raised") {
  const auto model = test::modelOf(kBattery, {.edition = codegen::Edition::Expanded});
  CHECK(test::printedProcess(model, "sv_battery_automata") ==
        R"(process sv_battery_automata (&battery_error: bool) is
states legal, error
from legal
    wait [0,0];
    on battery_error;
    #battery_forbidden;
    to error
)");
}

TEST_CASE("in the compact edition no step follows a forbidden move") {
  const auto model = test::modelOf(kBattery);
  CHECK(test::processOf(model, "sv_battery_automata").transitions.empty());
  CHECK_THAT(test::printed(model), !Contains("battery_error"));
}

TEST_CASE("a variable to which nothing is forbidden has no alarm") {
  const auto model = test::modelOf(R"(
    (defsv light :states (Off On) :init Off)
    (defevent flash :effects (light On)))");
  CHECK(test::processOf(model, "sv_light_automata").transitions.empty());
  CHECK_THAT(test::printed(model), !Contains("light_error"));
}

TEST_CASE("the paper's automaton has a state for each value, the initial one first, and polls") {
  const auto model = test::modelOf(kBattery, {.automata = codegen::StateVariableAutomata::Paper});
  CHECK(test::printedProcess(model, "sv_battery_automata") ==
        R"(process sv_battery_automata (&battery: sv_battery) is
states Low, Good, Critical, error
from Low
    wait [0,0];
    select
        on (battery = Good);
        to Good
    []
        on (battery = Critical);
        to Critical
    end
from Good
    wait [0,0];
    select
        on (battery = Low);
        to Low
    []
        on (battery = Critical);
        to error
    end
from Critical
    wait [0,0];
    select
        on (battery = Good);
        to error
    []
        on (battery = Low);
        to Low
    end
)");
  CHECK_THAT(test::printed(model), !Contains("battery_error"));
}

TEST_CASE("a value may be called error") {
  const auto model = test::modelOf("(defsv mode :states (ok error) :init error)",
                                   {.automata = codegen::StateVariableAutomata::Paper});
  CHECK(test::hasState(test::processOf(model, "sv_mode_automata"), "error_"));
}

TEST_CASE("a natural that may leave its bounds raises the alarm and stays at the bound") {
  CHECK(eventState(R"((defsv level :init 1 :min 1 :max 3)
                      (defevent up :effects (level (+ level 1))))",
                   "up") == R"(from start_
    up;
    if (level > 2) then
        #level_forbidden
    end;
    level := ((level > 2) ? 3 : (level + 1));
    to start_
)");
}

TEST_CASE("nothing goes below zero on the way to a natural's value") {
  CHECK_THAT(eventState(R"((defsv a :init 2 :min 0 :max 3) (defsv b :init 2 :min 0 :max 3)
                           (defevent down :effects (a (- a b))))",
                        "down"),
             Contains("a := ((a < b) ? 0 : (a - b))"));
}

TEST_CASE("a natural that stays within its bounds is just set") {
  CHECK_THAT(
      eventState(R"((defsv level :init 1 :min 1 :max 3) (defevent set :effects (level 2)))", "set"),
      Contains("set;\n    level := 2;\n"));
}

TEST_CASE("effects are set at once: what is read is what was there before") {
  CHECK_THAT(eventState(R"((defsv a :init 1 :min 0 :max 3) (defsv b :init 2 :min 0 :max 3)
                           (defevent swap :effects ((a b) (b a))))",
                        "swap"),
             Contains("a, b := b, a;"));
  CHECK_THAT(eventState(R"((defsv a :init 1 :min 0 :max 3) (defsv b :init 2 :min 0 :max 3)
                           (defevent copy :effects ((a b) (b 0))))",
                        "copy"),
             Contains("a := b;\n    b := 0;"));
}

TEST_CASE("a value may be called as its variable is, and moves to it are tested") {
  const std::string door = "(defsv door :states (door Open Closed) :init Open"
                           "  :transitions ((Open door) (door Closed)))";
  const std::string mission = "(defskill m :body ((set (door Closed)) (set (door door))))";
  CHECK(test::verdictsOf(door + mission).at("door.no_forbidden_transition") == "violated");
  CHECK(test::verdictsOf(door + "(defskill m :body ((set (door door)) (set (door Closed))))")
            .at("door.no_forbidden_transition") == "holds");
}

TEST_CASE("verdicts tell forbidden moves, exact and as the paper polls for them") {
  // with two moves at one instant, the polling automaton may see only the result
  const std::string twoSteps = R"(
    (defsv battery :states (Good Low Critical) :init Good :transitions ((Good Low) (Low Critical)))
    (defskill drain :body ((set (battery Low)) (set (battery Critical)))))";
  CHECK(test::verdictsOf(twoSteps).at("battery.no_forbidden_transition") == "holds");
  CHECK(test::verdictsOf(twoSteps, {.automata = codegen::StateVariableAutomata::Paper})
            .at("battery.no_forbidden_transition") == "violated");
  CHECK(test::verdictsOf(R"(
    (defsv level :init 1 :min 0 :max 3)
    (defskill count :body ((while (< level 3) (set (level (+ level 1)))))))")
            .at("level.no_forbidden_transition") == "holds");
  CHECK(test::verdictsOf(R"(
    (defsv level :init 1 :min 0 :max 3)
    (defskill count :body ((while (< level 3) (set (level (+ level 2)))))))")
            .at("level.no_forbidden_transition") == "holds");
}

TEST_CASE("of several initial values every one is looked at, before anything else happens") {
  const std::string text = "(defsv door :states (Closed Open Locked) :init (Closed Open))"
                           "(defsv n :min 0 :max 3 :init (1 3))"
                           "(defevent opens :effects (door Open))"
                           "(defskill m :success (was_open was_closed)"
                           " :body ((if (door Open) (success was_open)) (success was_closed)))"
                           "(defproperty three (reachable (= n 3)))"
                           "(defproperty both (reachable (and (= n 3) (door Open))))"
                           "(defproperty two (reachable (= n 2)))"
                           "(defproperty locked (reachable (door Locked)))"
                           "(defproperty from_closed (precedes (door Closed) (door Open)))"
                           "(defproperty known (always (or (= n 1) (= n 3))))"
                           "(defproperty first (ltl (door Closed)))"
                           "(defproperty some (ltl (or (door Closed) (door Open))))"
                           "(defproperty stays (ltl (=> (= n 3) ([] (= n 3)))))";
  for (const auto edition : {codegen::Edition::Compact, codegen::Edition::Expanded}) {
    const auto found = test::verdictsOf(text, {.edition = edition});
    CHECK(found.at("m.can_succeed.was_open") == "reachable");
    CHECK(found.at("m.can_succeed.was_closed") == "reachable");
    CHECK(found.at("three") == "reachable");
    CHECK(found.at("both") == "reachable");
    CHECK(found.at("two") == "unreachable");
    CHECK(found.at("locked") == "unreachable");
    CHECK(found.at("from_closed") == "violated");
    CHECK(found.at("known") == "holds");
    CHECK(found.at("first") == "violated");
    CHECK(found.at("some") == "holds");
    CHECK(found.at("stays") == "holds");
  }
}

TEST_CASE("the initial values are chosen one after the other") {
  const auto model = test::modelOf("(defsv door :states (Closed Open) :init (Closed Open))"
                                   "(defsv n :min 0 :max 3 :init (1 3))"
                                   "(defevent opens :effects (door Open))"
                                   "(defskill m :body ((^ 1)))");
  CHECK(test::printedState(model, "initial_values", "choose_1") == R"(from choose_1
    wait [0,0];
    select
        door := Closed
    []
        door := Open
    end;
    to choose_2
)");
  CHECK(test::printedState(model, "initial_values", "choose_2") == R"(from choose_2
    program_begins;
    select
        n := 1
    []
        n := 3
    end;
    skill[m].caller := root;
    to chosen
)");
  CHECK(test::printedState(model, "basic_environment_test", "before_") ==
        "from before_\n    program_begins;\n    to start_\n");
}

TEST_CASE("the polling automaton begins at the value that was chosen") {
  const auto found = test::verdictsOf(
      "(defsv door :states (Closed Open Locked) :init (Closed Open) :transitions ((Closed Locked)))"
      "(defskill m :body ((^ 1) (set (door Locked))))",
      {.automata = codegen::StateVariableAutomata::Paper});
  CHECK(found.at("door.no_forbidden_transition") == "violated");
  const auto allowed = test::verdictsOf("(defsv door :states (Closed Open Locked) :init (Closed "
                                        "Open) :transitions ((Closed Locked) (Open Locked)))"
                                        "(defskill m :body ((^ 1) (set (door Locked))))",
                                        {.automata = codegen::StateVariableAutomata::Paper});
  CHECK(allowed.at("door.no_forbidden_transition") == "holds");
}
