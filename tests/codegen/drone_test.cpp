#include "tests/codegen/model_of.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <sstream>

using namespace proskill;
using codegen::Edition;

namespace {

std::string droneProgram() {
  std::ifstream file(std::string(PROSKILL_SOURCE_DIR) + "/examples/drone/drone.proskill");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::size_t processes(const codegen::Model& model, std::string_view begin, std::string_view end) {
  return std::ranges::count_if(model.fiacre.processes, [&](const auto& process) {
    return process.name.starts_with(begin) && process.name.ends_with(end);
  });
}

} // namespace

TEST_CASE("the drone has the processes that the paper counts") {
  for (const auto edition : {Edition::Compact, Edition::Expanded}) {
    const auto model = test::modelOf(droneProgram(), {.edition = edition});
    CHECK(processes(model, "sv_", "_automata") == 7);
    CHECK(processes(model, "event_", "_automata") == 10);
    for (const auto* skill :
         {"start_drone", "takeoff", "goto_waypoint", "landing", "shutdown_drone", "camera_survey"})
      CHECK(processes(model, "skill_", skill) == 1);
    CHECK(processes(model, "skill_monitor_battery_critical", "") == 1);
    CHECK(processes(model, "skill_uav_mission", "_mission") == 1);
    CHECK(processes(model, "skill_branch_uav_mission_", "") == 2);
    CHECK(processes(model, "skill_uav_mission_watchdog", "") == 1);
    CHECK(processes(model, "basic_environment_", "") == 1);
    CHECK(model.fiacre.processes.size() == 7 + 10 + 6 + 1 + 1 + 2 + 1 + 1);
  }
}

TEST_CASE("the drone's branches are the paper's") {
  const auto model = test::modelOf(droneProgram());
  CHECK(test::hasState(test::processOf(model, "skill_branch_uav_mission_1_1"), "NS1_NS2_sync"));
  CHECK(test::hasState(test::processOf(model, "skill_uav_mission_watchdog"), "skill_overshoot"));
}

TEST_CASE("the drone's program for the executor has a task and an interrupt for each action") {
  const auto model = test::modelOf(droneProgram(), {.edition = Edition::Runtime});
  CHECK(model.fiacre.tasks.size() == 6);
  CHECK(model.fiacre.tasks[1].name == "Fiacre_takeoff_action_task");
  CHECK(model.fiacre.eventPorts.size() == 10 + 3);
  CHECK(model.fiacre.properties.empty());
}
