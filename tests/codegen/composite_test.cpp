#include "tests/codegen/model_of.h"

#include <catch2/catch.hpp>

using namespace proskill;
using Catch::Contains;

namespace {

const std::string kWorld = R"(
  (defsv light :states (Off On) :init Off)
  (defsv door :states (Closed Open) :init Closed)
  (defevent door_opens :effects (door Open))
  (defskill wave :time_interval [1,2] :action (wave) :success done)
  (defskill look :precondition (lit (light On)) :time_interval [1,2] :action (look)
    :interrupt (:effects (light Off)))
)";

codegen::Model missionOf(const std::string& body, const std::string& fields = "") {
  return test::modelOf(kWorld + "(defskill mission " + fields + " :body (" + body + "))");
}

std::string state(const codegen::Model& model, std::string_view name) {
  return test::printedState(model, "skill_mission", name);
}

std::map<std::string, std::string> verdicts(const std::string& rest) {
  return test::verdictsOf(kWorld + rest);
}

} // namespace

TEST_CASE("a call passes control and waits until it is back") {
  const auto model = missionOf("(wave) (set (light On))");
  CHECK(state(model, "NS1") == R"(from NS1
    wait [0,0];
    skill[wave].caller := mission;
    skill[wave].status := no_status;
    to NS1_NS2_sync
)");
  CHECK(state(model, "NS1_NS2_sync") == R"(from NS1_NS2_sync
    wait [0,0];
    on (skill[wave].caller = None);
    to NS2
)");
}

TEST_CASE("a call of a skill with a precondition sees when it is refused") {
  CHECK_THAT(state(missionOf("(look)"), "NS1_NS2_sync"),
             Contains("if (skill[look].status = no_status) then\n"
                      "        #mission_NS1_refused;\n        to NS2"));
}

TEST_CASE("tests, waits and effects are single transitions") {
  const auto model = missionOf(R"((^ (light On) :effects (light Off))
                                  (^ [0.5,2[)
                                  (if (= wave.status success) (set (light On))
                                   elseif (door Open) (printf "open")))");
  CHECK(state(model, "NS1") == R"(from NS1
    wait [0,0];
    on (light = On);
    light := Off;
    to NS2
)");
  CHECK(state(model, "NS2") == "from NS2\n    wait [1,4[;\n    to NS3\n");
  CHECK(state(model, "NS3") == R"(from NS3
    wait [0,0];
    if (skill[wave].status = success) then
        to N1_T
    elsif (door = Open) then
        to N1_T2
    else
        to NS4
    end
)");
}

TEST_CASE("parallel branches are called at once and all awaited") {
  const auto model = missionOf("(// ((wave)) ((set (light On)))) (set (light Off))");
  CHECK(state(model, "NS1") == R"(from NS1
    wait [0,0];
    skill[mission_branch_1_0].caller := mission;
    skill[mission_branch_1_1].caller := mission;
    to NS1_NS2_sync
)");
  CHECK(state(model, "NS1_NS2_sync") == R"(from NS1_NS2_sync
    wait [0,0];
    on ((skill[mission_branch_1_0].caller = None) and (skill[mission_branch_1_1].caller = None));
    to NS2
)");
  CHECK(test::printedProcess(model, "skill_branch_mission_1_1") ==
        R"(process skill_branch_mission_1_1 (&skill: skill_array, &light: sv_light) is
states idle, NS1, NS2
from idle
    wait [0,0];
    on (not (skill[mission_branch_1_1].caller = None));
    to NS1
from NS1
    wait [0,0];
    light := On;
    to NS2
from NS2
    wait [0,0];
    skill[mission_branch_1_1].caller := None;
    to idle
)");
}

TEST_CASE("a root has the caller root at time 0, and its end is no deadlock") {
  const auto model = missionOf("(wave)");
  CHECK_THAT(test::printed(model), Contains("{caller=root"));
  CHECK(state(model, "ended") == "from ended\n    wait [0,...[;\n    loop\n");
  CHECK(test::verdictsOf(kWorld + "(defskill mission :body ((wave)))").at("program.no_deadlock") ==
        "holds");
}

TEST_CASE("where time can pass a skill watches its guards, and stops what it has called") {
  const auto model = missionOf("(wave) (^ 1)", ":invariant (shut (:guard (door Closed)))");
  CHECK(state(model, "NS1_NS2_sync") == R"(from NS1_NS2_sync
    select
        on (door = Closed);
        wait [0,0];
        on (skill[wave].caller = None);
        to NS2
    []
        wait [0,0];
        on (not (door = Closed));
        skill[wave].stop := not (skill[wave].caller = None);
        to stopping
    end
)");
  CHECK(state(model, "stopping") == R"(from stopping
    wait [0,0];
    on (skill[wave].caller = None);
    #mission_failed_inv_shut;
    skill[mission].status := failed_inv;
    skill[mission].inv_active := false;
    skill[mission].caller := None;
    to ended
)");
}

TEST_CASE("nothing that a struck skill called is left running") {
  auto found = verdicts(R"(
    (defskill inner :body ((// ((wave)) ((^ 5)))))
    (defskill outer :invariant (shut (:guard (door Closed))) :body ((// ((inner)) ((look)))))
    (defproperty nothing_runs
      (never (and (ended outer failed_inv) (or (running wave) (running look) (running inner)))))
    (defproperty strikes (reachable (and (ended outer failed_inv) (= wave.status interrupted)))))");
  CHECK(found.at("nothing_runs") == "holds");
  CHECK(found.at("strikes") == "reachable");
  CHECK(found.at("program.time_progress") == "holds");
}

TEST_CASE("a branch can end the whole skill, and the first one decides how") {
  auto found = verdicts(R"(
    (defskill mission :success won :failure lost
      :body ((// ((^ 1) (success won)) ((^ 2) (failure lost)) ((wave))) (set (light On))))
    (defproperty alone (never (and (ended mission) (running wave))))
    (defproperty not_reached (never (light On))))");
  CHECK(found.at("mission.can_succeed.won") == "reachable");
  CHECK(found.at("mission.can_fail.lost") == "unreachable");
  CHECK(found.at("alone") == "holds");
  CHECK(found.at("not_reached") == "holds");
}

TEST_CASE("an interrupt stops a skill that runs, and leaves alone one that does not") {
  const std::string early = R"(
    (defskill mission :body ((look.interrupt) (set (light On)) (look)))
    (defenvironment quiet :body ())
    (defproperty stopped (reachable (ended look interrupted)))
    (defproperty done (reachable (ended look success))))";
  CHECK(verdicts(early).at("stopped") == "unreachable");
  CHECK(verdicts(early).at("done") == "reachable");
  const std::string late = R"(
    (defskill mission :body ((set (light On)) (// ((look)) ((^ 0.5) (look.interrupt)))))
    (defenvironment quiet :body ())
    (defproperty stopped (reachable (and (ended look interrupted) (light Off))))
    (defproperty done (reachable (ended look success))))";
  CHECK(verdicts(late).at("stopped") == "reachable");
  CHECK(verdicts(late).at("done") == "unreachable");
}

TEST_CASE("the interrupt of a composite skill reaches what it has called") {
  auto found = verdicts(R"(
    (defskill walk :interrupt (:effects (light Off)) :body ((set (light On)) (wave)))
    (defskill mission :body ((// ((walk)) ((^ 0.5) (walk.interrupt)))))
    (defenvironment quiet :body ())
    (defproperty both (reachable (and (ended walk interrupted) (ended wave interrupted))))
    (defproperty effects (never (and (ended walk interrupted) (light On)))))");
  CHECK(found.at("both") == "reachable");
  CHECK(found.at("effects") == "holds");
}

TEST_CASE("a call waits until a busy skill is free, and is told apart from one that does not") {
  auto found = verdicts(R"(
    (defskill mission :body ((// ((wave))
                                 ((^ 0.5) (wave))))))");
  CHECK(found.at("mission.never_busy.call[wave]") == "holds");
  CHECK(found.at("mission.never_busy.call[wave].2") == "violated");
  CHECK(found.at("mission.can_succeed") == "reachable");
  CHECK(found.at("program.no_deadlock") == "holds");
}

TEST_CASE("resources keep two skills apart without a deadlock") {
  auto found = verdicts(R"(
    (defresource arm)
    (defskill grip :resources (arm) :time_interval [1,2] :action (grip))
    (defskill lift :resources (arm) :time_interval [1,2] :action (lift))
    (defskill mission :body ((// ((grip)) ((lift)))))
    (defproperty apart (never (and (running grip) (running lift))))
    (defproperty both (reachable (and (ended grip success) (ended lift success)))))");
  CHECK(found.at("apart") == "holds");
  CHECK(found.at("both") == "reachable");
}
