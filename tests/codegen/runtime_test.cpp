#include "tests/codegen/model_of.h"

#include "fiacre/print/print.h"

#include <catch2/catch.hpp>

namespace proskill::test::runtime_test {

using Catch::Contains;
using codegen::Edition;

namespace {

const std::string kProgram = R"(
  (defsv motion :states (Free Used) :init Free)
  (defevent gust :effects (motion Free))
  (defskill move
    :input ($x float)
    :start (motion Used)
    :invariant (held (:guard (motion Used)))
    :time_interval [1,3]
    :action (move $x)
    :interrupt (:effects (motion Free))
    :success there (:effects (motion Free) :postcondition (motion Free))
    :failure lost)
  (defskill wave :action (wave))
  (defskill mission :time_interval [1,9] :body ((move x 1.5) (wave) (move x 2) (^ [1,2]))))";

codegen::Model runtime() { return test::modelOf(kProgram, {.edition = Edition::Runtime}); }
codegen::Model expanded() { return test::modelOf(kProgram, {.edition = Edition::Expanded}); }

} // namespace

TEST_CASE("expanded, every state of a basic skill has the paper's name") {
  const auto model = expanded();
  const auto& move = test::processOf(model, "skill_move");
  std::vector<std::string> states;
  for (const auto& state : move.states) states.push_back(state.name);
  CHECK(states == std::vector<std::string>{"start_", "check_precondition", "precondition_satisfied",
                                           "action", "interrupted", "success_there",
                                           "failed_success_postcondition_there", "failure_lost",
                                           "failed_invariant", "done", "ether"});
}

TEST_CASE("expanded, a timed outcome has one target, and its postcondition is told behind it") {
  CHECK_THAT(test::printedState(expanded(), "skill_move", "action"),
             Contains("broken := not (motion = Free);"));
  CHECK(test::printedState(expanded(), "skill_move", "success_there") == R"(from success_there
    wait [0,0];
    if broken then
        #move_success_there_postcondition;
        to failed_success_postcondition_there
    else
        to done
    end
)");
}

TEST_CASE("at runtime an action is a task, watched by ticks") {
  const auto sync = test::printedState(runtime(), "skill_move", "action_sync");
  CHECK_THAT(test::printedState(runtime(), "skill_move", "action"),
             Contains("start Fiacre_move_action_task(skill[move]);\n    to action_sync"));
  CHECK_THAT(sync, Contains("sync Fiacre_move_action_task ret_val;\n        if undershoot then\n"
                            "            #move_undershoot\n        end;"));
  CHECK_THAT(sync, Contains("wait [100,100];\n        to action_sync_not_undershoot"));
  CHECK_THAT(sync, Contains("wait [201,201];\n        #move_overshoot;"));
  CHECK_THAT(sync, Contains("on (not (motion = Used));\n"
                            "        ignoreb := Fiacre_move_interrupt_action();"));
  CHECK_THAT(sync, Contains("interrupt_move;\n"));
  CHECK_THAT(test::printedState(runtime(), "skill_move", "action_dispatch"),
             Contains("if (ret_val = move_success_there) then"));
}

TEST_CASE("an action without an interval is not watched, one that nothing stops not interrupted") {
  const auto wave = test::printedProcess(runtime(), "skill_wave");
  CHECK_THAT(wave, !Contains("shoot"));
  CHECK_THAT(wave, !Contains("Fiacre_wave_interrupt_action"));
  CHECK_THAT(wave, Contains("var ret_val: skill_result := no_result, ignoreb: bool := false\n"));
}

TEST_CASE("no process of a program for the executor is without a `from`") {
  for (const auto& process : runtime().fiacre.processes) CHECK_FALSE(process.transitions.empty());
}

TEST_CASE("events and interrupts from outside are event ports, and there is no environment") {
  const auto text = test::printed(runtime());
  CHECK_THAT(text, Contains("event gust: sync is c_gust\n"));
  CHECK_THAT(text, Contains("event interrupt_move: sync is c_interrupt_move\n"));
  CHECK_THAT(text, Contains("process event_gust_automata (&motion: sv_motion) is"));
  CHECK_THAT(text, !Contains("basic_environment"));
}

TEST_CASE("calls with arguments are numbered, others have the arguments 0") {
  CHECK_THAT(test::printedState(runtime(), "skill_mission", "NS1"),
             Contains("skill[move].ArgIndex := 1;"));
  CHECK_THAT(test::printedState(runtime(), "skill_mission", "NS2"),
             Contains("skill[wave].ArgIndex := 0;"));
  CHECK_THAT(test::printedState(runtime(), "skill_mission", "NS3"),
             Contains("skill[move].ArgIndex := 2;"));
  CHECK_THAT(test::printed(expanded()), !Contains("ArgIndex"));
}

TEST_CASE("an action that is told to stop keeps what its skill holds until it has returned") {
  const auto sync = test::printedState(runtime(), "skill_move", "action_sync");
  CHECK_THAT(sync, Contains("ignoreb := Fiacre_move_interrupt_action();\n"
                            "        to stopping_interrupted"));
  CHECK_THAT(sync, Contains("to stopping_failed_inv_held"));
  CHECK(test::printedState(runtime(), "skill_move", "stopping_interrupted") ==
        R"(from stopping_interrupted
    sync Fiacre_move_action_task ret_val;
    #move_interrupted;
    motion := Free;
    skill[move].status := interrupted;
    skill[move].inv_active := false;
    skill[move].caller := None;
    to interrupted
)");
}

TEST_CASE("the end of an action that was stopped does not say that it was stopped from outside") {
  CHECK_THAT(fiacre::print(runtime().fiacre), Contains("#move_interrupted; // is interrupted\n"
                                                       "    motion := Free;"));
}

TEST_CASE("no task is started under a wait") {
  CHECK_THAT(test::printedState(runtime(), "skill_move", "action"), !Contains("wait"));
}

TEST_CASE(
    "arguments are numbered for each skill, those that are a caller's parameters by its own") {
  const auto model = test::modelOf(R"(
    (defskill move :input ($x float $how string) :action (drive $how 7 $x) :success there)
    (defskill trip :input ($far float)
      :body ((move x $far how "slow") (move x 3 how "fast")))
    (defskill mission :body ((trip far 1) (trip far 2) (trip far 1))))",
                                   {.edition = Edition::Runtime});
  CHECK_THAT(test::printedState(model, "skill_mission", "NS2"),
             Contains("skill[trip].ArgIndex := 2;"));
  CHECK_THAT(test::printedState(model, "skill_mission", "NS3"),
             Contains("skill[trip].ArgIndex := 1;"));
  CHECK_THAT(test::printedState(model, "skill_trip", "NS1"),
             Contains("skill[trip].ArgIndex = 1) ? 1 : 3"));
  CHECK_THAT(test::printedState(model, "skill_trip", "NS2"),
             Contains("skill[move].ArgIndex := 2;"));
  using Calls = std::vector<codegen::ActionCall>;
  CHECK(model.actionCalls == Calls{{"move", 1, "drive", {"\"slow\"", "7", "1"}},
                                   {"move", 2, "drive", {"\"fast\"", "7", "3"}},
                                   {"move", 3, "drive", {"\"slow\"", "7", "2"}}});
  CHECK_THAT(model.fiacre.comment, Contains("move 3: (drive \"slow\" 7 2)"));
}

TEST_CASE("every wait of a runtime model is punctual") {
  const auto program = runtime().fiacre;
  const auto visit = [](const auto& self, const fiacre::Statement& statement) -> void {
    if (statement.kind == fiacre::StatementKind::Wait) {
      CHECK(statement.interval.upper == statement.interval.lower);
      CHECK_FALSE(statement.interval.lowerOpen);
    }
    for (const auto& child : statement.children) self(self, child);
  };
  for (const auto& process : program.processes)
    for (const auto& from : process.transitions) visit(visit, from.statement);
}

TEST_CASE("the platform reports an event with a time, and one that is early or late is told of") {
  const auto model = test::modelOf("(defsv door :states (Closed Open) :init Closed)"
                                   "(defevent opens :every [1,3] :effects (door Open))",
                                   {.edition = codegen::Edition::Runtime});
  const auto early = test::printedState(model, "event_opens_automata", "early");
  CHECK_THAT(early, Contains("wait [99,99];\n        to on_time"));
  CHECK_THAT(early, Contains("#opens_undershoot"));
  const auto onTime = test::printedState(model, "event_opens_automata", "on_time");
  CHECK_THAT(onTime, Contains("wait [202,202];"));
  CHECK_THAT(onTime, Contains("#opens_overshoot;\n        to late"));
}

} // namespace proskill::test::runtime_test
