#include "tests/codegen/model_of.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

/// Undershoot and overshoot of a mission that waits for a while.
std::string shoots(const std::string& interval, const std::string& wait) {
  auto found = test::verdictsOf("(defskill mission :time_interval " + interval + " :body ((^ " +
                                wait + ")))");
  const auto early = found.find("mission.no_undershoot");
  const auto late = found.find("mission.no_overshoot");
  return (early == found.end() ? "-" : early->second) + " " +
         (late == found.end() ? "-" : late->second);
}

/// The same for a skill that the mission calls three times.
std::string shootsAgain(const std::string& interval, const std::string& waits) {
  auto found = test::verdictsOf("(defskill step :time_interval " + interval + " :body (" + waits +
                                ")) (defskill mission :body ((step) (step) (^ 1) (step)))");
  CHECK(found.at("program.time_progress") == "holds");
  CHECK(found.at("program.no_deadlock") == "holds");
  CHECK(found.at("mission.can_succeed") == "reachable");
  const auto early = found.find("step.no_undershoot");
  return (early == found.end() ? "-" : early->second) + " " + found.at("step.no_overshoot");
}

} // namespace

TEST_CASE("the watchdog of a skill that runs once has the paper's states") {
  const auto model = test::modelOf("(defskill mission :time_interval [60,120] :body ((^ 70)))");
  CHECK(test::printedProcess(model, "skill_mission_watchdog") ==
        R"(process skill_mission_watchdog (&skill: skill_array) is
states idle, early, on_time, skill_undershoot, skill_overshoot
from idle
    wait [0,0];
    on skill[mission].inv_active;
    to early
from early
    select
        wait [60,60];
        to on_time
    []
        on (not skill[mission].inv_active);
        wait ]0,...[;
        to skill_undershoot
    end
from on_time
    select
        wait [0,0];
        on (not skill[mission].inv_active);
        to idle
    []
        wait ]60,...[;
        to skill_overshoot
    end
)");
}

TEST_CASE("bounds are exact, at the bound itself too") {
  CHECK(shoots("[2,4]", "[2,4]") == "holds holds");
  CHECK(shoots("[2,4]", "[1,4]") == "violated holds");
  CHECK(shoots("[2,4]", "[2,5]") == "holds violated");
  CHECK(shoots("[2,4]", "]1,2]") == "violated holds");
  CHECK(shoots("]2,4]", "[2,4]") == "violated holds");
  CHECK(shoots("]2,4]", "]2,4]") == "holds holds");
  CHECK(shoots("[2,4[", "[2,4]") == "holds violated");
  CHECK(shoots("[2,4[", "[2,4[") == "holds holds");
}

TEST_CASE("where a bound says nothing it is not asked for") {
  CHECK(shoots("[0,4]", "[0,4]") == "- holds");
  CHECK(shoots("[2,...[", "9") == "holds -");
  CHECK(shoots("]0,4]", "0") == "violated holds");
}

TEST_CASE("a skill may undershoot and overshoot") {
  CHECK(shoots("[60,120]", "[0,...[") == "violated violated");
}

TEST_CASE("runs that touch are told apart") {
  CHECK(shootsAgain("[2,4]", "(^ [2,4])") == "holds holds");
  CHECK(shootsAgain("[2,4]", "(^ [1,4])") == "violated holds");
  CHECK(shootsAgain("[2,4]", "(^ [2,5])") == "holds violated");
  CHECK(shootsAgain("]2,4[", "(^ ]2,4[)") == "holds holds");
  CHECK(shootsAgain("]2,4]", "(^ 2)") == "violated holds");
  CHECK(shootsAgain("[2,4[", "(^ 4)") == "holds violated");
}

TEST_CASE("runs that take no time are not added up") {
  CHECK(shootsAgain("[0,1]", "(^ [0,1])") == "- holds");
  // Three runs of a second each are not a run of three seconds.
  CHECK(shootsAgain("[1,2]", "(^ 1)") == "holds holds");
  // Each run is too short; none is too long.
  CHECK(shootsAgain("[3,5]", "(^ 2)") == "violated holds");
}
