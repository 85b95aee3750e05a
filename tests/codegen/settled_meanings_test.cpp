#include "tests/codegen/model_of.h"

#include <catch2/catch.hpp>

namespace proskill::test::settled_meanings_test {

using codegen::Edition;

namespace {

using Verdicts = std::map<std::string, std::string>;

/// The answers of both editions for verification.
Verdicts verdicts(const std::string& text) {
  auto compact = test::verdictsOf(text);
  CHECK(test::verdictsOf(text, {.edition = Edition::Expanded}) == compact);
  return compact;
}

} // namespace

TEST_CASE("a skill that never waits stops with its program, though it may be interrupted") {
  const auto found = verdicts(R"(
    (defsv door :states (Closed Open) :init Closed)
    (defskill note :interrupt (:effects (door Closed)) :body ((printf "x")))
    (defskill mission :body ((note) (^ (door Open)))))");
  CHECK(found.at("program.no_deadlock") == "violated");
}

TEST_CASE("what a body reads after its call is the outcome of that call") {
  const auto found = verdicts(R"(
    (defskill landing :time_interval [1,1] :success down :action (land))
    (defskill mission :success (landed) :failure (aloft)
      :body ((landing)
             (if (and (= landing.status success) (= landing.res down)) (success landed)
              else (failure aloft))))
    (defskill watch :monitor t :body ((landing))))");
  CHECK(found.at("mission.can_succeed.landed") == "reachable");
  CHECK(found.at("mission.can_fail.aloft") == "unreachable");
}

TEST_CASE("parallel branches each read the outcome of their own call") {
  const auto found = verdicts(R"(
    (defsv n :init 0 :min 0 :max 2)
    (defskill step :time_interval [1,1] :action (go))
    (defskill mission :success done :failure (lost)
      :body ((// ((step) (if (/= step.status success) (failure lost)))
                 ((step) (if (/= step.status success) (failure lost))))
             (success done))))");
  CHECK(found.at("mission.can_fail.lost") == "unreachable");
}

TEST_CASE("an interrupt ends a call that still waits for its resource") {
  const auto found = verdicts(R"(
    (defsv stopped :states (No Yes) :init No)
    (defresource arm)
    (defskill hold :resources (arm) :time_interval [5,5] :action (hold))
    (defskill move :resources (arm) :interrupt () :time_interval [1,1] :action (move))
    (defenvironment calm :body ())
    (defskill mission :body ((// ((hold)) ((^ 1) (move)) ((^ 2) (move.interrupt)))))
    (defproperty never_moves (never (running move)))
    (defproperty is_told (present (ended move interrupted))))");
  CHECK(found.at("never_moves") == "holds");
  CHECK(found.at("is_told") == "holds");
  CHECK(found.at("move.can_be_interrupted") == "reachable");
}

TEST_CASE("so does one from outside, and one for an idle skill has no effect") {
  const auto found = verdicts(R"(
    (defresource arm)
    (defskill hold :resources (arm) :time_interval [5,5] :action (hold))
    (defskill move :resources (arm) :interrupt () :time_interval [1,1] :action (move))
    (defenvironment button :body ((move.interrupt) (^ 2) (move.interrupt)))
    (defskill mission :body ((// ((hold)) ((^ 1) (move)))))
    (defproperty never_moves (never (running move))))");
  CHECK(found.at("never_moves") == "holds");
}

TEST_CASE("a skill that waits for its start has no status of the call before") {
  const auto found = verdicts(R"(
    (defresource arm)
    (defskill hold :resources (arm) :time_interval [2,2] :action (hold))
    (defskill move :resources (arm) :time_interval [1,1] :action (move))
    (defskill mission :body ((move) (^ 1) (move)))
    (defskill other :monitor t :body ((^ 1.5) (hold)))
    (defproperty waits (reachable (and (called move) (not (running move)) (= move.status no_status))))
    (defproperty old (reachable (and (called move) (not (running move)) (= move.status success)))))");
  CHECK(found.at("waits") == "reachable");
  CHECK(found.at("old") == "unreachable");
}

TEST_CASE("a guard that is false at the start of a body that takes no time is seen") {
  const auto found = verdicts(R"(
    (defsv door :states (Closed Open) :init Open)
    (defskill mission :invariant (shut (:guard (door Closed))) :success done
      :body ((printf "x") (success done))))");
  CHECK(found.at("mission.can_succeed.done") == "unreachable");
  CHECK(found.at("mission.invariant_may_fail.shut") == "reachable");
}

TEST_CASE("a guard that a body breaks and repairs at once is seen") {
  const auto found = verdicts(R"(
    (defsv door :states (Closed Open) :init Closed)
    (defskill mission :invariant (shut (:guard (door Closed))) :success done
      :body ((set (door Open)) (set (door Closed)) (success done))))");
  CHECK(found.at("mission.can_succeed.done") == "unreachable");
}

TEST_CASE("a branch that breaks a guard does nothing more") {
  const auto found = verdicts(R"(
    (defsv door :states (Closed Open) :init Closed)
    (defskill mission :invariant (shut (:guard (door Closed))) :success done
      :body ((// ((set (door Open)) (set (door Closed)))) (success done))))");
  CHECK(found.at("mission.can_succeed.done") == "unreachable");
  CHECK(found.at("program.no_deadlock") == "holds");
}

TEST_CASE("a mission or monitor that is refused when the program starts is told of") {
  const auto found = verdicts(R"(
    (defsv door :states (Closed Open) :init Closed)
    (defskill mission :body ((^ 1)))
    (defskill watch :monitor t :precondition (open (door Open)) :body ((^ (door Closed)))))");
  CHECK(found.at("watch.never_refused") == "violated");
  CHECK_FALSE(found.contains("mission.never_refused"));
}

TEST_CASE("a monitor that is always armed starts as soon as its precondition holds") {
  const std::string program = R"(
    (defsv door :states (Closed Open) :init Closed)
    (defskill mission :body ((^ 1) (set (door Open)) (^ 1) (set (door Closed))))
    (defskill watch :precondition (open (door Open)) :body ((^ 5)) :monitor )";
  const auto refused = verdicts(program + "t)");
  CHECK(refused.at("watch.can_run") == "unreachable");
  const auto armed = verdicts(program + "always)");
  CHECK(armed.at("watch.can_run") == "reachable");
  CHECK_FALSE(armed.contains("watch.never_refused"));
  CHECK(verdicts(program + "always) (defproperty at_once (leadsto (door Open) (running watch) "
                           ":within [0,0]))")
            .at("at_once") == "holds");
}

TEST_CASE("a monitor that is always armed starts once each time its precondition becomes true") {
  const auto found = verdicts(R"(
    (defsv door :states (Closed Open) :init Closed)
    (defsv count :init 0 :min 0 :max 3)
    (defskill mission
      :body ((^ 1) (set (door Open)) (^ 1) (set (door Closed))
             (^ 1) (set (door Open)) (^ 1) (set (door Closed)) (^ 1)))
    (defskill watch :monitor always :precondition (open (door Open))
      :body ((set (count (+ count 1)))))
    (defproperty once_each_time (always (or (= count 0) (= count 1) (= count 2))))
    (defproperty twice (present (= count 2)))
    (defproperty at_once (leadsto (door Open) (ended watch) :within [0,0]))
    (defproperty waits_again (leadsto (door Closed) (called watch) :within [0,0])))");
  CHECK(found.at("once_each_time") == "holds");
  CHECK(found.at("twice") == "holds");
  CHECK(found.at("at_once") == "holds");
  CHECK(found.at("waits_again") == "holds");
  CHECK(found.at("program.time_progress") == "holds");
}

TEST_CASE("a monitor that is always armed starts again after it has failed or was interrupted") {
  const auto found = verdicts(R"(
    (defsv door :states (Closed Open) :init Closed)
    (defsv count :init 0 :min 0 :max 3)
    (defskill mission
      :body ((set (door Open)) (^ 1) (set (door Closed)) (^ 1)
             (set (door Open)) (^ 1) (watch.interrupt) (set (door Closed)) (^ 1)
             (set (door Open)) (^ 1)))
    (defskill watch :monitor always :precondition (open (door Open)) :interrupt ()
      :start (count (+ count 1)) :invariant (open (:guard (door Open)))
      :body ((^ 5)))
    (defenvironment calm :body ())
    (defproperty thrice (present (= count 3))))");
  CHECK(found.at("thrice") == "holds");
  CHECK(found.at("watch.invariant_may_fail.open") == "reachable");
  CHECK(found.at("watch.can_be_interrupted") == "reachable");
}

TEST_CASE("a monitor that is always armed and has no precondition runs once") {
  const auto found = verdicts(R"(
    (defsv count :init 0 :min 0 :max 3)
    (defskill mission :body ((^ 1)))
    (defskill watch :monitor always :body ((set (count (+ count 1)))))
    (defproperty once (never (> count 1))))");
  CHECK(found.at("once") == "holds");
  CHECK(found.at("program.time_progress") == "holds");
}

TEST_CASE("a body whose last test ends it either way has no end that could not be reached") {
  const auto found = verdicts(R"(
    (defsv door :states (Closed Open) :init Closed)
    (defskill mission :success ok :failure ko
      :body ((if (door Open) (success ok) else (failure ko)))))");
  CHECK_FALSE(found.contains("mission.can_succeed"));
  CHECK(found.contains("mission.can_succeed.ok"));
}

TEST_CASE("a skill that must not be stopped keeps a caller that ends early waiting") {
  const std::string program = R"(
    (defsv door :states (Closed Open) :init Closed)
    (defevent opens :effects (door Open))
    (defskill put_down :time_interval [2,3] :action (put_down) FIELD)
    (defskill mission :success done :invariant (shut (:guard (door Closed)))
      :body ((put_down) (success done)))
    (defproperty is_put_down (absent (ended put_down interrupted) :after (running put_down)))
    (defproperty ends_at_once (leadsto (and (running mission) (door Open))
                                       (ended mission) :within [0,1])))";
  const auto with = [&](const std::string& field) {
    auto text = program;
    return verdicts(text.replace(text.find("FIELD"), 5, field));
  };
  const auto plain = with("");
  CHECK(plain.at("is_put_down") == "violated");
  CHECK(plain.at("ends_at_once") == "holds");
  const auto unstoppable = with(":interruptible nil");
  CHECK(unstoppable.at("is_put_down") == "holds");
  CHECK(unstoppable.at("ends_at_once") == "violated");
  CHECK(unstoppable.at("mission.invariant_may_fail.shut") == "reachable");
}

TEST_CASE("who waits for what must not be stopped does not hold up others") {
  const auto found = verdicts(R"(
    (defsv door :states (Closed Open) :init Closed)
    (defevent opens :effects (door Open))
    (defskill grip :time_interval [1,1] :action (grip))
    (defskill put_down :interruptible nil :success down
      :body ((^ 5) (grip) (success down)))
    (defskill mission :invariant (shut (:guard (door Closed))) :body ((put_down))))");
  CHECK(found.at("program.no_deadlock") == "holds");
  CHECK(found.at("put_down.can_succeed.down") == "reachable");
  CHECK(found.at("mission.invariant_may_fail.shut") == "reachable");
}

TEST_CASE("a call of what must not be stopped is cancelled while it waits for its start") {
  const auto found = verdicts(R"(
    (defresource arm)
    (defskill holder :monitor t :resources (arm) :body ((^ 9)))
    (defskill put_down :interruptible nil :resources (arm) :action (put_down))
    (defskill mission :success done
      :body ((// ((^ 1) (put_down)) ((^ 2) (success done)))))
    (defproperty never_begun (never (running put_down))))");
  CHECK(found.at("never_begun") == "holds");
  CHECK(found.at("mission.can_succeed.done") == "reachable");
}

TEST_CASE("a case goes on with the arm for the outcome, and nobody comes between") {
  const auto found = verdicts(R"(
    (defsv door :states (Closed Open) :init Open)
    (defevent moves :effects (door Closed))
    (defskill drive :precondition (open (door Open)) :time_interval [1,2] :action (drive)
      :success (near far) :failure blocked)
    (defskill mission :success ok :failure (stuck refused)
      :body ((case (drive)
               ((success near) (success ok))
               (success)
               (failure (if (= drive.status failure) (failure stuck)))
               (refused (failure refused)))
             (^ 1)))
    (defproperty no_other (never (and (ended mission success) (= mission.res ok)
                                      (/= drive.res near)))))");
  CHECK(found.at("mission.can_succeed.ok") == "reachable");
  CHECK(found.at("mission.can_fail.stuck") == "reachable");
  CHECK(found.at("mission.can_fail.refused") == "reachable");
  CHECK(found.at("mission.reachable.case[drive]") == "reachable");
  CHECK(found.at("mission.never_refused.case[drive]") == "violated");
  CHECK(found.at("no_other") == "holds");
}

TEST_CASE("a case knows its own outcome though others call the skill") {
  const auto found = verdicts(R"(
    (defskill landing :time_interval [1,1] :success down :failure lost :action (land))
    (defskill mission :success landed :failure aloft
      :body ((case (landing) (success (success landed)) (failure (failure aloft)))))
    (defskill watch :monitor t
      :body ((case (landing) ((success down)) (else (^ 1)))))
    (defproperty is_so (always (=> (= mission.status failure) (/= mission.res landed)))))");
  CHECK(found.at("mission.can_succeed.landed") == "reachable");
  CHECK(found.at("mission.can_fail.aloft") == "reachable");
  CHECK(found.at("is_so") == "holds");
}

TEST_CASE("a wait with a timeout ends by it at its date, and not before") {
  const auto found = verdicts(R"(
    (defsv door :states (Closed Open) :init Closed)
    (defevent opens :effects (door Open))
    (defskill mission :time_interval [0,3] :success (open closed)
      :body ((^ (door Open) :timeout [2,3] (success closed)) (success open)))
    (defproperty not_before (absent (= mission.res closed) :after (running mission) :for [0,2[))
    (defproperty sees_it (leadsto (and (running mission) (door Open)) (ended mission)
                                  :within [0,0])))");
  CHECK(found.at("mission.can_succeed.open") == "reachable");
  CHECK(found.at("mission.can_succeed.closed") == "reachable");
  CHECK(found.at("mission.no_overshoot") == "holds");
  CHECK(found.at("not_before") == "holds");
  CHECK(found.at("sees_it") == "holds");
}

TEST_CASE("behind the statements of a timeout the body goes on as behind the wait") {
  const auto found = verdicts(R"(
    (defsv door :states (Closed Open) :init Closed)
    (defskill mission :success done
      :body ((while (door Closed)
               (^ (door Open) :effects (door Closed) :timeout 1 (set (door Open))))
             (success done)))
    (defproperty in_a_second (present (ended mission success) :within [1,1])))");
  CHECK(found.at("in_a_second") == "holds");
}

} // namespace proskill::test::settled_meanings_test
