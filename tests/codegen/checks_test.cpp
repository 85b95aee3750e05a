#include "fiacre/print/print.h"
#include "tests/codegen/model_of.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace proskill;
using codegen::Expectation;
using codegen::Weight;

namespace {

const std::string kProgram = R"(
(defsv battery :states (Good Low) :init Good)
(defsv level :init 0 :min 0 :max 3)
(defevent drain :effects (battery Low))
(defskill wave
  :precondition (full (battery Good))
  :invariant (power (:guard (battery Good)))
  :time_interval [1,2]
  :action (wave)
  :interrupt (:effects (level 1))
  :success done (:postcondition (level 0))
  :failure tired)
(defskill mission
  :time_interval [1,9]
  :success won
  :body ((label again)
         (wave)
         (if (= wave.res tired) (goto again))
         (success won)))
)";

std::vector<std::string> namesOf(const codegen::Model& model) {
  std::vector<std::string> names;
  for (const auto& check : model.checks) names.push_back(check.name);
  return names;
}

const codegen::Check& checkOf(const codegen::Model& model, const std::string& name) {
  const auto found = std::ranges::find(model.checks, name, &codegen::Check::name);
  INFO("no check " << name);
  REQUIRE(found != model.checks.end());
  return *found;
}

/// A property of the program as it is printed.
std::string patternOf(const std::string& property) {
  const auto model = test::modelOf(kProgram + "(defproperty wish " + property + ")");
  const auto& check = checkOf(model, "wish");
  CHECK(check.kind == "property");
  return fiacre::printPattern(model.fiacre.properties[check.property].pattern, "main_test");
}

} // namespace

TEST_CASE("what has no skills may stop") {
  const auto asked = [](const std::string& program) {
    return std::ranges::count(namesOf(test::modelOf(program)), "program.no_deadlock");
  };
  CHECK(asked("(defsv light :states (On Off) :init On)") == 0);
  CHECK(asked("(defskill go :action (go))") == 1);
}

TEST_CASE("every part of a program has its default properties") {
  CHECK(namesOf(test::modelOf(kProgram)) ==
        std::vector<std::string>{
            "battery.no_forbidden_transition", "level.no_forbidden_transition", "wave.can_run",
            "wave.can_succeed.done", "wave.postcondition.done", "wave.can_fail.tired",
            "wave.invariant_may_fail.power", "wave.can_be_interrupted", "mission.can_run",
            "mission.can_succeed.won", "mission.no_undershoot", "mission.no_overshoot",
            "mission.never_refused.call[wave]", "mission.reachable.call[wave]",
            "mission.reachable.if[wave]", "mission.reachable.goto[again]",
            "mission.reachable.success[won]", "program.no_deadlock", "program.time_progress"});
}

TEST_CASE("the name of a question outlives edits elsewhere") {
  const std::string before = R"(
    (defsv light :states (Off On) :init Off)
    (defskill wave :action (wave) :precondition (dark (light Off)))
    (defskill mission :body ((wave) (// ((^ 1) (wave)) ((^ (light On)))) (set (light On)))))";
  const auto names = namesOf(test::modelOf(before));
  for (const char* expected :
       {"mission.never_refused.call[wave]", "mission.never_refused.call[wave].2",
        "mission.reachable.parallel", "mission.reachable.delay", "mission.reachable.wait[light]",
        "mission.reachable.set[light]"})
    CHECK_THAT(names, Catch::Matchers::VectorContains(std::string(expected)));
  auto after = before;
  after.replace(after.find(":body ("), 7, ":body ((printf \"off\")\n  (^ (raised 1))\n  ");
  for (const auto& name :
       namesOf(test::modelOf("\n\n(defsv raised :init 0 :min 0 :max 1)" + after)))
    if (!name.ends_with(".printf") && !name.contains("raised"))
      CHECK_THAT(names, Catch::Matchers::VectorContains(name));
}

TEST_CASE("a check says what is good, how bad the other is, and where it is about") {
  const auto model = test::modelOf(kProgram);
  const auto& run = checkOf(model, "wave.can_run");
  CHECK(run.kind == "can_run");
  CHECK(run.subject == "wave");
  CHECK(run.description == "`wave` can run");
  CHECK(run.good == Expectation::Reachable);
  CHECK(run.weight == Weight::Warning);
  CHECK(checkOf(model, "battery.no_forbidden_transition").weight == Weight::Error);
  CHECK(checkOf(model, "mission.no_overshoot").good == Expectation::Holds);
  CHECK(checkOf(model, "mission.never_refused.call[wave]").weight == Weight::Warning);
  const auto& origin =
      model.provenance.origins[checkOf(model, "mission.reachable.success[won]").origin];
  CHECK(kProgram.substr(origin.begin, origin.end - origin.begin) == "(success won)");
}

TEST_CASE("names of checks and of properties are unique, whatever the program calls its own") {
  const auto model = test::modelOf(kProgram + R"(
    (defproperty program (always true))
    (defproperty wave (always true)))");
  std::set<std::string> names;
  std::set<std::string> properties;
  for (const auto& check : model.checks) {
    CHECK(names.insert(check.name).second);
    CHECK(properties.insert(model.fiacre.properties[check.property].name).second);
  }
}

TEST_CASE("what can never happen is asked for all the same") {
  auto found = test::verdictsOf(R"(
    (defskill wave :action (wave) :precondition (never false) :success done)
    (defskill mission :success (won lost) :body ((wave) (success won))))");
  CHECK(found.at("wave.can_run") == "unreachable");
  CHECK(found.at("mission.can_succeed.won") == "reachable");
  CHECK(found.at("mission.can_succeed.lost") == "unreachable");
  CHECK(found.at("mission.never_refused.call[wave]") == "violated");
}

TEST_CASE("the program's own properties are Fiacre's patterns") {
  CHECK(patternOf("(always (battery Good))") == "always main_test/value (battery = Good)");
  CHECK(patternOf("(never (and (running wave) (battery Low)))") ==
        "absent ((main_test/value skill[wave].inv_active) and (main_test/value (battery = Low)))");
  CHECK(patternOf("(reachable (occurs drain))") == "absent main_test/event drain");
  CHECK(patternOf("(deadlockfree)") == "deadlockfree");
  CHECK(patternOf("(infinitelyoften (battery Good))") ==
        "infinitelyoften main_test/value (battery = Good)");
  CHECK(patternOf("(leadsto (battery Low) (called wave) :within [0,1])") ==
        "(main_test/value (battery = Low)) leadsto "
        "(main_test/value (not (skill[wave].caller = None))) within [0,1]");
  CHECK(patternOf("(precedes (= level 1) (value level 2))") ==
        "(main_test/value (level = 1)) precedes (main_test/value (level = 2))");
  CHECK(patternOf("(present (ended wave success) :after (battery Low))") ==
        "present main_test/value ((skill[wave].caller = None) and (skill[wave].status = success))"
        " after main_test/value (battery = Low)");
  CHECK(patternOf("(absent (battery Low) :before (ended wave) :for [0,2])") ==
        "absent main_test/value (battery = Low) before main_test/value ((skill[wave].caller = None)"
        " and (not (skill[wave].status = no_status))) for interval [0,2]");
  CHECK(patternOf("(ltl (W (battery Low) (running wave)))") ==
        "ltl ((main_test/value (battery = Low)) until "
        "(main_test/value skill[wave].inv_active)) or ([] (main_test/value (battery = Low)))");
  CHECK(patternOf("(ltl (R (battery Low) (running wave)))") ==
        "ltl not ((not (main_test/value (battery = Low))) until "
        "(not (main_test/value skill[wave].inv_active)))");
  CHECK(patternOf("(ltl (M (battery Low) (running wave)))") ==
        "ltl (main_test/value skill[wave].inv_active) until "
        "((main_test/value (battery = Low)) and (main_test/value skill[wave].inv_active))");
  CHECK(patternOf("(ltl ([] (=> (battery Low) (<> (running wave)))))") ==
        "ltl [] ((main_test/value (battery = Low)) => "
        "(<> (main_test/value skill[wave].inv_active)))");
}

TEST_CASE("at a label is any state of the statement behind it") {
  CHECK(patternOf("(reachable (at again))") ==
        "absent ((main_test/5/state NS1) or (main_test/5/state NS1_NS2_sync))");
}

TEST_CASE("a result is compared by its tag, whatever its status") {
  CHECK(patternOf("(always (/= wave.res power))") ==
        "always main_test/value (not (skill[wave].val = wave_failed_inv_power))");
  CHECK(patternOf("(always (= wave.res no_result))") ==
        "always main_test/value (skill[wave].val = no_result)");
}

TEST_CASE("verdicts of the program's own properties") {
  auto found = test::verdictsOf(kProgram + R"(
    (defproperty stays (always (battery Good)))
    (defproperty drains (reachable (occurs drain)))
    (defproperty not_while_low (never (and (ended wave failed_inv) (battery Good))))
    (defproperty at_again (reachable (and (at again) (running wave)))))");
  CHECK(found.at("stays") == "violated");
  CHECK(found.at("drains") == "reachable");
  CHECK(found.at("not_while_low") == "holds");
  CHECK(found.at("at_again") == "reachable");
}
