#include "tests/codegen/model_of.h"

#include <catch2/catch.hpp>

namespace proskill::test::environment_test {

using Catch::Contains;

namespace {

const std::string kWorld = R"(
  (defsv door :states (Closed Open) :init Closed)
  (defevent door_opens :effects (door Open))
  (defevent door_closes :effects (door Closed))
  (defskill wave :time_interval [2,4] :action (wave) :interrupt (:effects (door Closed)))
)";

std::map<std::string, std::string> verdicts(const std::string& rest) {
  return test::verdictsOf(kWorld + rest);
}

} // namespace

TEST_CASE("the most general environment takes every port at any time") {
  const auto model = test::modelOf(kWorld + "(defskill mission :body ((wave)))");
  CHECK(
      test::printedProcess(model, "basic_environment_test") ==
      R"(process basic_environment_test [door_opens: sync, door_closes: sync, interrupt_wave: sync] is
states start_
from start_
    select
        door_opens
    []
        door_closes
    []
        interrupt_wave
    end;
    to start_
)");
}

TEST_CASE("an event sets its effects when its port is taken") {
  const auto model = test::modelOf(kWorld);
  CHECK(test::printedProcess(model, "event_door_opens_automata") ==
        R"(process event_door_opens_automata [door_opens: sync] (&door: sv_door) is
states start_
from start_
    door_opens;
    door := Open;
    to start_
)");
}

TEST_CASE("an event with a guard occurs only while the guard holds") {
  const std::string slam = "(defsv wind :states (Calm Strong) :init Calm)"
                           "(defevent slams :guard (and (door Open) (wind Strong)) "
                           ":effects (door Closed))"
                           "(defproperty slams_shut (reachable (occurs slams)))";
  CHECK(test::printedProcess(test::modelOf(kWorld + slam), "event_slams_automata") ==
        R"(process event_slams_automata [slams: sync] (&door: sv_door, &wind: sv_wind) is
states start_
from start_
    on ((door = Open) and (wind = Strong));
    slams;
    door := Closed;
    to start_
)");
  CHECK(verdicts(slam).at("slams_shut") == "unreachable");
  CHECK(verdicts(slam + "(defevent storm :effects (wind Strong))").at("slams_shut") == "reachable");
}

TEST_CASE("an environment that generates an event waits for its guard") {
  const auto waits = verdicts(R"(
    (defsv wind :states (Calm Strong) :init Calm)
    (defevent slams :guard (door Open) :effects (wind Strong))
    (defskill mission :body ((^ 3) (set (door Open)) (^ 9)))
    (defenvironment world :body ((emit slams)))
    (defproperty early (absent (wind Strong) :for [0,3[))
    (defproperty late (leadsto (door Open) (wind Strong) :within [0,0])))");
  CHECK(waits.at("early") == "holds");
  CHECK(waits.at("late") == "holds");
}

TEST_CASE("an environment of the program's own is in a hurry, and says all that happens") {
  const auto text = test::printed(test::modelOf(kWorld + R"(
    (defskill mission :body ((wave)))
    (defenvironment hall :body ((^ 3) (emit door_opens))))"));
  CHECK_THAT(text, Contains("port door_opens: sync in [0,0]"));
  CHECK_THAT(text, Contains("[door_opens: sync, door_closes: sync, interrupt_wave: sync] is"));
  CHECK_THAT(text, Contains("from NS2\n    door_opens;\n    to NS3\n"));
}

TEST_CASE("what an environment does not do does not happen") {
  auto found = verdicts(R"(
    (defskill mission :body ((wave)))
    (defenvironment hall :body ((^ 3) (emit door_opens)))
    (defproperty opens (reachable (door Open)))
    (defproperty at_three (reachable (and (door Open) (running wave))))
    (defproperty closes (reachable (occurs door_closes))))");
  CHECK(found.at("opens") == "reachable");
  CHECK(found.at("at_three") == "reachable");
  CHECK(found.at("closes") == "unreachable");
  CHECK(found.at("wave.can_be_interrupted") == "unreachable");
}

TEST_CASE("an environment interrupts what is running, and goes on where nothing is") {
  auto found = verdicts(R"(
    (defskill mission :body ((^ 2) (wave)))
    (defenvironment hall
      :body ((wave.interrupt) (emit door_opens) (^ 3) (wave.interrupt) (emit door_opens)))
    (defproperty interrupted (reachable (and (ended wave interrupted) (door Open))))
    (defproperty done (reachable (ended wave success)))
    (defproperty opens_early (reachable (and (door Open) (= wave.status no_status)))))");
  CHECK(found.at("interrupted") == "reachable");
  CHECK(found.at("done") == "unreachable");
  CHECK(found.at("opens_early") == "reachable");
}

TEST_CASE("an environment may choose, loop and test") {
  auto found = verdicts(R"(
    (defskill mission :body ((^ (door Open)) (wave)))
    (defenvironment hall
      :body ((while true (^ 1) (choose ((emit door_opens)) ((if (door Open) (emit door_closes)))))))
    (defproperty closes (reachable (occurs door_closes))))");
  CHECK(found.at("closes") == "reachable");
  CHECK(found.at("mission.can_succeed") == "reachable");
  CHECK(found.at("program.time_progress") == "holds");
}

TEST_CASE("without a mission any basic skill may be called at any time") {
  const auto model = test::modelOf(kWorld);
  CHECK(test::printedProcess(model, "most_general_caller") ==
        R"(process most_general_caller (&skill: skill_array) is
states start_
from start_
    on (skill[wave].caller = None);
    wait [0,...[;
    skill[wave].caller := root;
    skill[wave].status := no_status;
    to start_
)");
  CHECK(verdicts("").at("wave.can_be_interrupted") == "reachable");
}

TEST_CASE("in a library a monitor and the most general caller share the skills") {
  auto found = verdicts("(defskill watch :monitor t :body ((^ (door Open)) (wave)))");
  CHECK(found.at("watch.can_succeed") == "reachable");
  CHECK(found.at("watch.never_busy.call[wave]") == "violated");
  CHECK(found.at("program.time_progress") == "holds");
}

TEST_CASE("an event with a time between its occurrences comes by itself") {
  const std::string beat = "(defsv n :init 0 :min 0 :max 9) (defevent beat :every INTERVAL "
                           ":effects (n (+ n 1))) (defskill m :success done :body (";
  const auto found = [&](const std::string& interval, const std::string& body,
                         const std::string& rest) {
    auto text = beat + body + "))" + rest;
    return test::verdictsOf(text.replace(text.find("INTERVAL"), 8, interval));
  };
  const std::string early = "(defproperty early (absent (= n 2) :for [0,4]))"
                            "(defproperty at_four (absent (= n 2) :for [0,4[))"
                            "(defproperty twice (present (= n 2) :within [0,10]))";
  for (const std::string world : {"", "(defenvironment w :body ((^ 100)))"}) {
    auto verdicts = found("[2,5]", "(^ 100)", early + world);
    CHECK(verdicts.at("early") == "violated");
    CHECK(verdicts.at("at_four") == "holds");
    CHECK(verdicts.at("twice") == "holds");
    verdicts = found("]2,...[", "(^ 100)", early + world);
    CHECK(verdicts.at("early") == "holds");
    CHECK(verdicts.at("twice") == "violated");
  }
}

TEST_CASE("only an event that has to come saves the time") {
  const auto verdict = [](const std::string& every) {
    return test::verdictsOf("(defsv door :states (Closed Open) :init Closed)"
                            "(defevent opens " +
                            every +
                            " :effects (door Open))"
                            "(defskill look :precondition (open (door Open)) :action (look))"
                            "(defskill m :body ((^ 5) (while (= look.status no_status) (look))))")
        .at("program.time_progress");
  };
  CHECK(verdict("") == "violated");
  CHECK(verdict(":every [5,6]") == "violated");
  CHECK(verdict(":every [5,...[") == "violated");
  CHECK(verdict(":every [5,5]") == "holds");
  CHECK(verdict(":every [1,4]") == "holds");
}

TEST_CASE("the time between two occurrences is that of the port, or of a state of its own") {
  const std::string text = "(defsv door :states (Closed Open) :init Closed)"
                           "(defevent opens :every [2,5[ :effects (door Open))"
                           "(defevent closes :effects (door Closed))";
  const auto compact = test::printed(test::modelOf(text));
  CHECK_THAT(compact, Contains("port closes: sync, opens: sync in [2,5["));
  CHECK_THAT(compact, Contains("process basic_environment_test [closes: sync] is"));
  const auto model = test::modelOf(text, {.edition = codegen::Edition::Expanded});
  CHECK(test::printedState(model, "event_opens_automata", "start_") ==
        "from start_\n    wait [2,5[;\n    to due\n");
  CHECK_THAT(test::printed(model), Contains("opens: sync in [0,0]"));
}

} // namespace proskill::test::environment_test
