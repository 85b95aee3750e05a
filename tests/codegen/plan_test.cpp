#include "codegen/plan/plan.h"
#include "tests/codegen/model_of.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

using namespace proskill;
using Catch::Contains;

namespace {

const std::string kTwoMissions = R"(
  (defskill wave :action (wave))
  (defskill greet :body ((wave)))
  (defskill morning :body ((greet)))
  (defskill evening :body ((wave)))
  (defproperty evenings (reachable (running evening)))
  (defproperty not_yet (always (= evening.status no_status))))";

std::vector<std::string> processes(const codegen::Model& model) {
  std::vector<std::string> names;
  for (const auto& instance : model.fiacre.components[0].instances)
    names.push_back(instance.process);
  return names;
}

} // namespace

TEST_CASE("processes stand in the order of state variables, events, skills, environment") {
  const auto model = test::modelOf(R"(
    (defskill mission :time_interval [1,2] :body ((// ((wave)) ((wave)))))
    (defskill watch :monitor t :body ((wave)))
    (defskill wave :action (wave))
    (defevent rain :effects (wet Yes))
    (defsv wet :states (No Yes) :init No))");
  CHECK(processes(model) ==
        std::vector<std::string>{"sv_wet_automata", "event_rain_automata", "skill_wave",
                                 "skill_mission", "skill_branch_mission_1_0",
                                 "skill_branch_mission_1_1", "skill_mission_watchdog",
                                 "skill_watch", "basic_environment_test"});
}

TEST_CASE("several candidates for the mission are an error that names them") {
  CHECK(test::errorOf(kTwoMissions).message ==
        "several skills could be the mission: `morning`, `evening`");
}

TEST_CASE("the mission may be chosen; what only another one calls is left out and never runs") {
  const codegen::Options evening{.mainSkill = "evening"};
  CHECK(processes(test::modelOf(kTwoMissions, evening)) ==
        std::vector<std::string>{"skill_wave", "skill_evening", "basic_environment_test"});
  const codegen::Options morning{.mainSkill = "morning"};
  CHECK(test::verdictsOf(kTwoMissions, evening).at("evenings") == "reachable");
  CHECK(test::verdictsOf(kTwoMissions, morning).at("evenings") == "unreachable");
  CHECK(test::verdictsOf(kTwoMissions, morning).at("not_yet") == "holds");
}

TEST_CASE("a mission that is none is an error") {
  CHECK_THAT(test::errorOf(kTwoMissions, {.mainSkill = "noon"}).message,
             Contains("no skill `noon`"));
  CHECK_THAT(test::errorOf(kTwoMissions, {.mainSkill = "wave"}).message, Contains("basic skill"));
}

TEST_CASE("a mission may be one that another skill calls too") {
  const std::string text = R"(
    (defskill wave :action (wave))
    (defskill greet :body ((wave)))
    (defskill watch :monitor t :body ((greet))))";
  CHECK(test::verdictsOf(text, {.mainSkill = "greet"}).at("watch.never_busy.call[greet]") ==
        "violated");
  CHECK(test::verdictsOf(text, {.mainSkill = "greet"}).at("watch.can_succeed") == "reachable");
}

TEST_CASE("whoever can be struck may stop what it calls, directly or not") {
  const auto program = test::programOfText(R"(
    (defsv door :states (Closed Open) :init Closed)
    (defskill wave :action (wave))
    (defskill look :action (look))
    (defskill inner :body ((wave)))
    (defskill outer :invariant (shut (:guard (door Closed))) :body ((inner)))
    (defskill mission :body ((outer) (look))))");
  const auto plan = codegen::makeGenerationPlan(program, {});
  REQUIRE(plan.has_value());
  CHECK(plan->find("inner")->callerMayStop);
  CHECK(plan->find("wave")->callerMayStop);
  CHECK_FALSE(plan->find("outer")->mayBeStopped());
  CHECK_FALSE(plan->find("look")->mayBeStopped());
}
