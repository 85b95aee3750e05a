#include "tests/syntax/programs.h"

#include <fstream>
#include <sstream>

#include "tests/where.h"

namespace proskill::test {

const std::string_view kPaperStateVariables = R"proskill((defsv flight_levels
  :init 1
  :min 1
  :max 3)

(defsv battery
  :states (Good Low Critical) ; the possible values the state variable can take
  :init Good ; the initial value
  :transitions ; use the :all keyword if all transitions are allowed,
    ((Good Low)(Low Critical) ; list them otherwise.
     (Critical Low)(Low Good)))
)proskill";

const std::string_view kPaperEvent = R"proskill((defevent battery_to_critical
  :effects (battery Critical))
)proskill";

const std::string_view kPaperBasicSkill = R"proskill((defskill takeoff
  :input ($height float $duration float)      ; The expected arguments
  :precondition (not_moving (motion Free)     ; a list of taged  (state_variable value)
           on_ground (flight_status OnGround) ; all four preconditions need to be satisfied
           battery_good (battery Good)
           origin_valid (localization_status Valid))
  :start (motion Controlled)                  ; state_variable to set upon starting this skill
  :invariant (in_control (:guard (motion Controlled)) ; all the guards are monitored while
              battery (:guard (~ (battery Critical))  ; the drone takeoff, if one
                        :effects (motion Free)))      ; fails, its effects, if any, are set
                                                    ; and the action is interrupted
  :time_interval [1,3]   ; this is the interval of time in seconds this action takes
  :action (takeoff)      ; this is linked to the C/C++ code which will be invoked
  :interrupt (:effects (motion Free)) ; when interrupted, set this state_variable
  :success at_altitude                           ; success, and their effects on state_variable
          (:effects (motion Free)                ; postcondition are just checked for
           :postcondition (flight_status InAir)) ; model consistency
  :failure (grounded (:effects (motion Free)     ; they are not enforced
             :postcondition (flight_status OnGround))
            emergency (:effects (motion Free)
             :postcondition (flight_status InAirUnsafe))))
)proskill";

const std::string_view kPaperCompositeSkill = R"proskill((defskill uav_mission
  :time_interval [60 , 120] ; expected min and max time to perform this skill.
  :success mission_accomplished ; success and
    (:effects (mission_status Succeeded)) ; its effect
  :failure mission_failed ; failure and
    (:effects (mission_status Failed)) ; its effect
  :start (mission_status Ongoing) ; setting the mission status SV upon starting
  :body
    ((start_drone) ; This will call the start_drone basic skill
     (^ (localization_status Valid)) ; wait for the localization to be Valid
     (takeoff height 3.0 duration 0) ; call the takeoff basic skill (3 meters)
     (if (= takeoff.status success) ; if the takeoff status is success
        (// ((camera_survey)) ; execute two branches in parallel camera_survey on one
            ((goto_waypoint x 1 y 2 z 3 yaw 0 duration 0) ; navigation on the other one
             (^ 2)     ; wait 2 seconds
             (goto_waypoint x -3 y -2 z 4 yaw 1.4 duration 0) ; navigating to a new position
             (camera_survey.interrupt))) ; interrupt the camera_survey skill
     (if (= goto_waypoint.status success) ;the last goto_waypoint was a success
        (landing) ; call the landing skill
        (if (= landing.status success) ; if successful
           (shutdown_drone) ; call the shutdown_drone skill
           (printf "Mission Accomplished") ; print a message
           (success mission_accomplished)))) ; return the mission_accomplished success
    (printf "Mission failed") ; otherwise, print and report failure.
    (failure mission_failed)))
)proskill";

const std::string_view kPaperMonitor = R"proskill((defskill monitor_battery_critical
  :monitor t ; Mark this skill as a monitoring one (hence it gets started upon startup)
  :body ((^ (battery Critical)) ; wait until the battery becomes critical
         (printf "We will try to land the drone safely...") ; print a message
         (set_velocity vx 0.0 vy 0.0 vz -0.1) ; force landing by setting -10cm/s vertical speed
        ))
)proskill";

std::string paperProgram() {
  std::string text;
  for (auto listing :
       {kPaperStateVariables, kPaperEvent, kPaperBasicSkill, kPaperCompositeSkill, kPaperMonitor})
    text += std::string(listing) + "\n";
  return text;
}

std::vector<std::string> allPrograms() {
  std::vector<std::string> programs{paperProgram()};
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(PROSKILL_SOURCE_DIR "/examples")) {
    if (entry.path().extension() != ".proskill") continue;
    std::ostringstream text;
    text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    programs.push_back(text.str());
  }
  return programs;
}

std::string codesOf(const syntax::Document& document) {
  std::string codes;
  for (const auto& diagnostic : document.diagnostics()) {
    if (!codes.empty()) codes += ' ';
    codes += syntax::info(diagnostic.code).id;
  }
  return codes;
}

} // namespace proskill::test
