#include "syntax/diagnostics/codes.h"
#include "tests/analysis/findings.h"
#include "tests/syntax/programs.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

/// What the paper's listings use without showing it.
constexpr std::string_view kRest = R"(
(defsv flight_status :states (NotReady OnGround InAir InAirUnsafe Lost) :init NotReady)
(defsv localization_status :states (Invalid Coarse Valid) :init Invalid)
(defsv mission_status :states (Unknown Ongoing Failed Succeeded) :init Unknown)
(defsv motion :states (Free Controlled) :init Free)
(defskill start_drone :action (start_drone))
(defskill shutdown_drone :action (shutdown_drone))
(defskill landing :action (landing))
(defskill camera_survey :action (camera_survey) :interrupt (:effects (motion Free)))
(defskill goto_waypoint
  :input ($x float $y float $z float $yaw float $duration float)
  :action (goto_waypoint $x $y $z $yaw $duration))
(defskill set_velocity
  :input ($vx float $vy float $vz float)
  :action (set_velocity $vx $vy $vz))
)";

} // namespace

TEST_CASE("the paper's drone is clean once its other parts are there") {
  CHECK(test::findings(test::paperProgram() + std::string(kRest)) == "");
}

TEST_CASE("without them, each name that is missing is told, and nothing else") {
  for (const auto& it : test::diagnose(test::paperProgram())) {
    INFO(it.message);
    CHECK((it.code == syntax::Code::UnknownSkill || it.code == syntax::Code::UnknownStateVariable));
  }
}
