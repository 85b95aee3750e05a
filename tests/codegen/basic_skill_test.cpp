#include "tests/codegen/model_of.h"

#include <catch2/catch.hpp>

using namespace proskill;
using Catch::Contains;

namespace {

/// The paper's takeoff with its dependencies, called by a mission.
const std::string kTakeoff = R"(
  (defsv motion :states (Free Controlled) :init Free)
  (defsv battery :states (Good Low Critical) :init Good)
  (defsv flight_status :states (OnGround InAir) :init OnGround)
  (defskill takeoff
    :input ($height float)
    :precondition (not_moving (motion Free) on_ground (flight_status OnGround))
    :start (motion Controlled)
    :invariant (in_control (:guard (motion Controlled))
                battery (:guard (~ (battery Critical)) :effects (motion Free)))
    :time_interval [1,3]
    :action (takeoff)
    :interrupt (:effects (motion Free))
    :success at_altitude (:effects (motion Free) :postcondition (flight_status InAir))
    :failure (grounded (:effects (motion Free))))
  (defskill mission :body ((takeoff height 3.0))))";

} // namespace

TEST_CASE("a basic skill is the paper's compact process") {
  CHECK(test::printedProcess(test::modelOf(kTakeoff), "skill_takeoff") ==
        R"(process skill_takeoff
    [interrupt_takeoff: sync]
    (&skill: skill_array, &motion: sv_motion, &battery: sv_battery,
     &flight_status: sv_flight_status) is
states idle, run
from idle
    select
        wait [0,0];
        on (not (skill[takeoff].caller = None));
        on (not invariant_active(skill, motion, battery));
        if ((motion = Free) and (flight_status = OnGround)) then
            #takeoff_run;
            motion := Controlled;
            skill[takeoff].inv_active := true;
            to run
        else
            skill[takeoff].caller := None;
            to idle
        end
    []
        on (not (skill[takeoff].caller = None));
        interrupt_takeoff;
        #takeoff_interrupted;
        skill[takeoff].status := interrupted;
        skill[takeoff].caller := None;
        to idle
    end
from run
    select
        wait [1,3];
        #takeoff_success_at_altitude;
        motion := Free;
        if (not (flight_status = InAir)) then
            #takeoff_success_at_altitude_postcondition
        end;
        skill[takeoff].status := success
    []
        wait [1,3];
        #takeoff_failure_grounded;
        motion := Free;
        skill[takeoff].status := failure
    []
        interrupt_takeoff;
        #takeoff_interrupted;
        motion := Free;
        skill[takeoff].status := interrupted
    []
        wait [0,0];
        on (not (motion = Controlled));
        #takeoff_failed_inv_in_control;
        skill[takeoff].status := failed_inv
    []
        wait [0,0];
        on (battery = Critical);
        #takeoff_failed_inv_battery;
        motion := Free;
        skill[takeoff].status := failed_inv
    end;
    skill[takeoff].inv_active := false;
    skill[takeoff].caller := None;
    to idle
)");
}

TEST_CASE("a skill without outcomes succeeds, at any time where it has no interval") {
  CHECK(test::printedState(test::modelOf("(defskill wave :action (wave))"), "skill_wave", "run") ==
        R"(from run
    wait [0,...[;
    #wave_success;
    skill[wave].status := success;
    skill[wave].inv_active := false;
    skill[wave].caller := None;
    to idle
)");
}

TEST_CASE("resources are waited for, taken with the start and given back at the end") {
  const auto model = test::modelOf(R"(
    (defresource power :capacity 2)
    (defskill lamp :resources (power) :action (lamp)))");
  const auto idle = test::printedState(model, "skill_lamp", "idle");
  CHECK_THAT(idle, Contains("on (power_used < 2);"));
  CHECK_THAT(idle, Contains("power_used := power_used + 1;"));
  CHECK_THAT(test::printedState(model, "skill_lamp", "run"),
             Contains("power_used := power_used - 1;"));
}

TEST_CASE("results are kept of the skills whose result is read, and of no others") {
  const auto model = test::modelOf(R"(
    (defskill look :action (look) :success (seen nothing) :failure blind)
    (defskill wave :action (wave) :success done)
    (defskill mission :body ((look) (wave) (if (= look.res blind) (wave)))))");
  CHECK_THAT(test::printedProcess(model, "skill_look"),
             Contains("skill[look].val := look_success_nothing;"));
  CHECK_THAT(test::printedProcess(model, "skill_wave"), !Contains(".val"));
  CHECK_THAT(test::printedState(model, "skill_mission", "NS3"),
             Contains("if (skill[look].val = look_failure_blind) then"));
}

TEST_CASE("a skill that two processes call stays taken until its caller has seen its end") {
  const auto model = test::modelOf(R"(
    (defskill wave :action (wave))
    (defskill mission :body ((// ((wave)) ((wave))))))");
  CHECK_THAT(test::printedState(model, "skill_wave", "idle"),
             Contains("on ((not (skill[wave].caller = None)) and (not skill[wave].returned));"));
  CHECK_THAT(test::printedState(model, "skill_wave", "run"),
             Contains("skill[wave].returned := true;\n    to idle"));
  CHECK(test::printedState(model, "skill_branch_mission_1_0", "NS1_NS2_sync") ==
        R"(from NS1_NS2_sync
    wait [0,0];
    on skill[wave].returned;
    skill[wave].returned := false;
    skill[wave].caller := None;
    to NS2
)");
}

TEST_CASE("only a skill that something interrupts has a stop") {
  const auto model = test::modelOf(R"(
    (defsv eye :states (Open Shut) :init Open)
    (defskill look :action (look) :interrupt (:effects (eye Shut)))
    (defskill wave :action (wave))
    (defskill mission :body ((// ((look)) ((wave) (look.interrupt))))))");
  CHECK_THAT(test::printedState(model, "skill_look", "run"), Contains("on skill[look].stop;"));
  CHECK_THAT(test::printedProcess(model, "skill_wave"), !Contains("stop"));
}

TEST_CASE("what a basic skill does is what its program says") {
  auto verdicts = test::verdictsOf(kTakeoff);
  CHECK(verdicts.at("takeoff.can_run") == "reachable");
  CHECK(verdicts.at("takeoff.can_succeed.at_altitude") == "reachable");
  CHECK(verdicts.at("takeoff.can_fail.grounded") == "reachable");
  CHECK(verdicts.at("takeoff.can_be_interrupted") == "reachable");
  CHECK(verdicts.at("takeoff.invariant_may_fail.battery") == "unreachable"); // no event drains it
  CHECK(verdicts.at("takeoff.postcondition.at_altitude") == "violated");     // no event lifts it
  CHECK(verdicts.at("mission.never_refused.call[takeoff]") == "holds");
}
