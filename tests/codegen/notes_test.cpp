#include "tests/codegen/model_of.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;

namespace {

/// What the verdict on deadlocks rests on.
std::string noteOf(const std::string& program) {
  const auto model = test::modelOf(program);
  const auto found = std::ranges::find(model.checks, "program.no_deadlock", &codegen::Check::name);
  REQUIRE(found != model.checks.end());
  return found->note;
}

const std::string kDoor = "(defsv door :states (Closed Open) :init Closed)"
                          "(defsv u :states (P Q) :init P)";
const std::string kMission = "(defskill mission :body ((^ (door Open))))";

std::string since(const std::string& help) {
  return "since " + help +
         "; whether the mission can always end is the question "
         "`(always_reachable (ended mission))`";
}

} // namespace

TEST_CASE("a verdict on deadlocks says if it rests on a step that is always possible") {
  CHECK(noteOf(kDoor + kMission).empty());
  CHECK(noteOf(kDoor + kMission + "(defevent e :effects (u Q))") == since("`e` can always occur"));
  CHECK(noteOf(kDoor + kMission + "(defevent e :every [1,...[ :effects (u Q))") ==
        since("`e` can always occur"));
  CHECK(noteOf(kDoor + "(defskill mission :interrupt () :body ((^ (door Open))))") ==
        since("`mission` can always be interrupted"));
  CHECK(noteOf(kDoor + kMission +
               "(defskill watch :monitor always :precondition (open (door Open)) :interrupt () "
               ":body ())") == since("`watch` can always be interrupted"));
  CHECK(noteOf(kDoor + kMission + "(defenvironment calm :body ((while true (^ 1))))") ==
        since("the environment always goes on"));
  CHECK(noteOf(kDoor + kMission + "(defskill beat :monitor t :body ((while true (^ 1))))") ==
        since("`beat` always goes on"));
}

TEST_CASE("a step that may become impossible for ever is no such step") {
  CHECK(noteOf(kDoor + kMission + "(defevent e :guard (u P) :effects (u Q))").empty());
  CHECK(noteOf(kDoor + kMission + "(defenvironment calm :body ((^ 1)))").empty());
  CHECK(
      noteOf(kDoor + kMission + "(defenvironment calm :body ((while true (^ 1) (^ (door Open)))))")
          .empty());
  CHECK(noteOf(kDoor + kMission +
               "(defskill beat :monitor t :body ((while true (^ 1) (if (u Q) break))))")
            .empty());
  CHECK(noteOf(kDoor + kMission +
               "(defskill beat :monitor t :invariant (i (:guard (u P)))"
               " :body ((while true (^ 1))))")
            .empty());
}

TEST_CASE("the question that the note names is answered") {
  const std::string stops = kDoor + kMission +
                            "(defevent e :effects (u Q))"
                            "(defproperty ends (always_reachable (ended mission)))";
  const auto found = test::verdictsOf(stops);
  CHECK(found.at("program.no_deadlock") == "holds");
  CHECK(found.at("ends") == "violated");
  CHECK(test::verdictsOf(stops + "(defevent opens :effects (door Open))").at("ends") == "holds");
}

TEST_CASE("nobody is asked to change what no program can do otherwise") {
  const std::string drive = "(defskill a :time_interval [1,2] :action (x))";
  const auto ofBody = [&](const std::string& body) {
    return test::verdictsOf(drive + "(defskill m :success ok :failure ko :body (" + body + "))");
  };
  const auto race = ofBody("(race ((a) (success ok)) ((^ 1) (failure ko)))");
  CHECK_FALSE(race.contains("m.can_succeed"));
  CHECK(race.at("m.can_succeed.ok") == "reachable");
  CHECK_FALSE(ofBody("(// ((a) (success ok)) ((^ 1)))").contains("m.can_succeed"));
  CHECK(ofBody("(race ((a) (success ok)) ((^ 1)))").at("m.can_succeed") == "reachable");
  const auto loop = ofBody("(do (a) (if (= a.status success) (success ok) else (failure ko)) "
                           "until false)");
  CHECK(std::ranges::none_of(
      loop, [](const auto& verdict) { return verdict.first.starts_with("m.reachable.do"); }));
  CHECK_FALSE(loop.contains("m.can_succeed"));
  CHECK(ofBody("(do (a) until (= a.status success))").at("m.reachable.do[a]") == "reachable");
}

TEST_CASE("an arm for a refusal that never comes is not a statement to reach") {
  const auto found = test::verdictsOf(R"(
    (defsv v :states (A B) :init A)
    (defskill a :precondition (p (v A)) :time_interval [1,2] :action (x))
    (defskill m :success ok :failure ko
      :body ((case (a) (success (success ok)) (refused (failure ko))))))");
  CHECK_FALSE(found.contains("m.reachable.failure[ko]"));
  CHECK(found.at("m.reachable.success[ok]") == "reachable");
}

TEST_CASE("an interrupt ends the call under way, and whoever waits for its turn starts after it") {
  const std::string program = R"(
    (defskill x :interrupt () :time_interval [5,5] :action (x))
    (defskill mission :success done :failure stopped
      :body ((x) (if (= x.status interrupted) (failure stopped) else (success done))))
    (defskill second :monitor t :success done :failure stopped
      :body ((^ 1) (x) (if (= x.status interrupted) (failure stopped) else (success done))))
    (defskill stop :monitor t :body ((^ 2) (x.interrupt)))
    (defenvironment calm :body ())
    (defproperty again (reachable (and (ended stop) (running x)))))";
  for (const auto edition : {codegen::Edition::Compact, codegen::Edition::Expanded}) {
    const auto found = test::verdictsOf(program, {.edition = edition});
    CHECK(found.at("mission.can_fail.stopped") == "reachable");
    CHECK(found.at("second.can_fail.stopped") == "unreachable");
    CHECK(found.at("second.can_succeed.done") == "reachable");
    CHECK(found.at("again") == "reachable");
  }
}

TEST_CASE(
    "the state of the first `from` is the initial one, also with a choice of initial values") {
  for (const auto edition : {codegen::Edition::Expanded, codegen::Edition::Tina}) {
    const auto model = test::modelOf("(defsv v :states (A B) :init (A B))"
                                     "(defevent e :every [1,2] :effects (v A))"
                                     "(defevent f :effects (v B))"
                                     "(defskill m :body ((^ (v B))))",
                                     {.edition = edition});
    for (const auto& process : model.fiacre.processes) {
      INFO(process.name);
      if (!process.transitions.empty())
        CHECK(process.transitions.front().state == process.states.front().name);
    }
  }
}
