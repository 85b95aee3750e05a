#include "tests/analysis/findings.h"

#include <catch2/catch.hpp>

using proskill::test::diagnose;
using proskill::test::findings;
using proskill::test::kWorld;
using proskill::test::mission;

TEST_CASE("a state variable is an enumeration or a natural") {
  CHECK(findings("(defsv s :init A)") == "PS0404 s");
  CHECK(findings("(defsv s)") == "PS0404 s");
  CHECK(findings("(defsv s :states (A B))") == "PS0401 s");
  CHECK(findings("(defsv s :init 1 :min 1)") == "PS0401 s");
  CHECK(findings("(defsv s :max 1)") == "PS0401 s");
  CHECK(findings("(defsv s :states (A B) :init A :min 0)") == "PS0403 :min");
  CHECK(findings("(defsv s :init 0 :min 0 :max 1 :transitions :all)") == "PS0403 :transitions");
  CHECK(diagnose("(defsv s :max 1)")[0].message == "state variable `s` needs `:init` and `:min`");
}

TEST_CASE("a skill is basic or composite") {
  CHECK(findings("(defskill s :action (s))") == "");
  CHECK(findings("(defskill s :body ())") == "");
  CHECK(findings("(defskill s)") == "PS0406 s");
  CHECK(findings("(defskill s :action (s) :body ((^ 1)))") == "PS0405 :body");
  CHECK(findings("(defskill s :body ((^ 1)) :action (s))") == "PS0405 :action");
  CHECK(findings("(defskill s :monitor t :action (s))") == "PS0403 :monitor");
  CHECK(findings("(defskill s :monitor t :body ((^ 1)))") == "");
}

TEST_CASE("fields are there once") {
  CHECK(findings("(defskill s :action (s) :action (t))") == "PS0402 :action");
  CHECK(findings("(defsv s :states (A) :init A :init A)") == "PS0402 :init");
  CHECK(findings("(defresource r :capacity 1 :capacity 2)") == "PS0402 :capacity");
  CHECK(findings(kWorld + "(defskill s :action (s) :invariant (a (:guard (level 1) :guard (level "
                          "2))))") == "PS0402 :guard");
  CHECK(findings(kWorld + "(defskill s :action (s) :interrupt (:effects (level 1) :effects (level "
                          "2)))") == "PS0402 :effects");
  CHECK(findings(kWorld + "(defproperty p (absent (level 1) :for [1,2] :for [1,3]))") ==
        "PS0402 :for");
  CHECK(findings("(defevent e)") == "PS0401 e");
  CHECK(findings("(defenvironment e)") == "PS0401 e");
}

TEST_CASE("a misspelt keyword or a lost parenthesis is no missing field too") {
  CHECK(findings(kWorld + "(defevent e :efects (battery Low))") == "PS0113 :efects");
  CHECK(findings("(defsv s\n  :states (A B\n  :init A)\n(defresource r)") == "PS0101 (");
  CHECK(findings("(defsv s :states (A B))\n  :init A)\n") == "PS0102 )");
}

TEST_CASE("an interval holds some duration") {
  auto interval = [](const std::string& text) {
    return findings("(defskill s :time_interval " + text + " :action (s))");
  };
  CHECK(interval("[1,3]") == "");
  CHECK(interval("[2,2]") == "");
  CHECK(interval("]0,...[") == "");
  CHECK(interval("[3,1]") == "PS0410 [3,1]");
  CHECK(interval("[2,2[") == "PS0411 [2,2[");
  CHECK(interval("]2,2]") == "PS0411 ]2,2]");
  CHECK(interval("[-1,2]") == "PS0116 [-1,2]");
  CHECK(findings(mission("(^ [3,1])")) == "PS0410 [3,1]");
  CHECK(findings(kWorld + "(defproperty p (leadsto (level 1) (level 2) :within [3,1]))") ==
        "PS0410 [3,1]");
  const auto found = diagnose("(defskill s :time_interval ]3,1.5] :action (s))");
  REQUIRE(found.size() == 1);
  CHECK(found[0].fixes.at(0).text == "[1.5,3[");
}

TEST_CASE("a resource can be held, and is taken once") {
  CHECK(findings("(defresource r :capacity 2)") == "");
  CHECK(findings("(defresource r :capacity 0)") == "PS0412 0");
  CHECK(findings("(defresource r :capacity 1.5)") == "PS0412 1.5");
  CHECK(findings("(defresource r :capacity many)") == "PS0212 many");
  CHECK(findings(kWorld + "(defskill s :resources (arm arm) :action (s))") == "PS0413 arm");
}

TEST_CASE("a jump stays in its body or branch") {
  CHECK(findings(mission("(label a) (while true (if (level 1) (goto a)))")) == "");
  CHECK(findings(mission("(goto b) (while true (label b))")) == "");
  CHECK(findings(mission("(// ((label a) (goto a)) ((^ 1)))")) == "");
  CHECK(findings(mission("(label a) (// ((goto a)) ((^ 1)))")) == "PS0431 a");
  CHECK(findings(mission("(goto a) (// ((label a)) ((^ 1)))")) == "PS0431 a");
  CHECK(findings(mission("(// ((label a)) ((goto a)))")) == "PS0431 a");
  CHECK(findings(mission("(race ((label a)) ((^ 1) (goto a)))")) == "PS0431 a");
  CHECK(findings(mission("(goto a)") + "(defskill other :body ((label a)))") == "PS0207 a");
}

TEST_CASE("break leaves a loop") {
  CHECK(findings(mission("(while true break)")) == "");
  CHECK(findings(mission("(do (if (level 1) (break)) until true)")) == "");
  CHECK(findings(mission("break")) == "PS0430 break");
  CHECK(findings(mission("(while true (// (break) ((^ 1))))")) != "");
  CHECK(findings(mission("(while true (// ((^ 1) break) ((^ 1))))")) == "PS0430 break");
}

TEST_CASE("an environment makes events and interrupts happen, and does nothing itself") {
  auto environment = [](const std::string& body) {
    return findings(kWorld + "(defenvironment e :body (" + body + "))");
  };
  CHECK(environment("(label a) (^ [1,3]) (emit drained) (^ (battery Low)) (survey.interrupt)"
                    "(choose ((emit charged)) ((^ 1) (goto a)))"
                    "(while (level 1) (if (level 2) break)) (do (^ 1) until true)"
                    "(printf \"%s\" battery)") == "");
  CHECK(environment("(survey)") == "PS0433 survey");
  CHECK(environment("(set (battery Low))") == "PS0433 set");
  CHECK(environment("(success done)") == "PS0433 success");
  CHECK(environment("(failure done)") == "PS0433 failure");
  CHECK(environment("(// ((emit drained)) ((emit charged)))") == "PS0433 //");
  CHECK(environment("(race ((emit drained)) ((emit charged)))") == "PS0433 race");
  CHECK(environment("(^ (level 1) :effects (battery Low))") == "PS0433 (battery Low)");
  CHECK(findings(mission("(emit drained)")) == "PS0432 emit");
  CHECK(findings(mission("(choose ((^ 1)) ((^ 2)))")) == "PS0432 choose");
}

TEST_CASE("with an upper time limit it does not matter which runs without end are fair") {
  const auto present = [](const std::string& fields) {
    return findings("(defsv s :states (A B) :init A) (defproperty p (present (s B) " + fields +
                    "))");
  };
  CHECK(present(":within [0,2] :fair t") == "PS0403 :fair");
  CHECK(present(":within [2,...[ :fair t") == "");
  CHECK(present(":lasting 2 :fair nil") == "");
}

TEST_CASE("a skill that is never stopped is not interrupted either") {
  CHECK(findings("(defskill s :interruptible nil :interrupt () :action (s))") ==
        "PS0403 :interrupt");
  CHECK(findings("(defskill s :interruptible t :interrupt () :action (s))") == "");
}

TEST_CASE("a case has an arm for each outcome, and no other") {
  const std::string drive =
      "(defsv door :states (Open Closed) :init Open)"
      "(defskill drive :precondition (open (door Open)) :invariant (open (:guard (door Open)))"
      "  :interrupt () :success (near far) :failure lost :action (drive))"
      "(defskill m :body ((case (drive) ";
  const auto with = [&](const std::string& arms) { return findings(drive + arms + ")))"); };
  CHECK(with("(success) (failure) (failed_inv) (interrupted) (refused)") == "");
  CHECK(with("((success near far)) ((failure lost)) ((failed_inv open)) (else)") == "");
  CHECK(with("(else)") == "");
  CHECK(with("(success) (failure) (failed_inv) (interrupted)") == "PS0434 case");
  CHECK(with("((success near)) (failure) (failed_inv) (interrupted) (refused)") == "PS0434 case");
  CHECK(with("(success) ((success near)) (else)") == "PS0435W (success near)");
  CHECK(with("(success) (failure) (failed_inv) (interrupted) (refused) (else)") == "PS0435W else");
  CHECK(with("((success nera)) (else)") == "PS0205 nera");
  CHECK(with("(succes) (else)") == "PS0211 succes");
  CHECK(with("((success lost)) (else)") == "PS0205 lost");
}

TEST_CASE("a body that runs to its end is a success of its own for a case") {
  const auto with = [&](const std::string& body, const std::string& arms) {
    return findings("(defskill go :success far :failure lost :body (" + body +
                    ")) (defskill m :body ((case (go) " + arms + ")))");
  };
  CHECK(with("(^ 1)", "((success far)) (failure)") == "PS0434 case");
  CHECK(with("(^ 1)", "((success far)) (success) (failure)") == "");
  CHECK(with("(^ 1) (success far)", "((success far)) (failure)") == "");
  CHECK(with("(while true (^ 1))", "((success far)) (failure)") == "");
  CHECK(with("(while true (^ 1) break)", "((success far)) (failure)") == "PS0434 case");
}

TEST_CASE("a program has one environment") {
  CHECK(findings(kWorld + "(defenvironment e :body ((^ 1))) (defenvironment f :body ((^ 1)))") ==
        "PS0440 f");
  CHECK(findings(kWorld + "(defenvironment e :body ((^ 1))) (defenvironment e :body ((^ 1)))") ==
        "PS0440 e");
}

TEST_CASE("a format takes its arguments") {
  CHECK(findings(mission("(printf \"level %d of %d, 100%%, %s %f\" level 3 battery 1.5)")) == "");
  CHECK(findings(mission("(printf \"%s %s %s\" takeoff.status takeoff.res \"x\")")) == "");
  CHECK(findings(mission("(printf \"%d\" (+ level 1))")) == "");
  CHECK(findings(mission("(printf \"%f\" -2)")) == "");
  CHECK(findings(mission("(printf \"%d\")")) == "PS0330 %d");
  CHECK(findings(mission("(printf \"on\" level)")) == "PS0330 on");
  CHECK(findings(mission("(printf \"%d\" battery)")) == "PS0331 battery");
  CHECK(findings(mission("(printf \"%d\" 1.5)")) == "PS0331 1.5");
  CHECK(findings(mission("(printf \"%s\" level)")) == "PS0331 level");
  CHECK(findings(mission("(printf \"%x\" level)")) == "PS0332 %x");
  CHECK(findings(mission("(printf \"50%\")")) == "PS0332 %");
  CHECK(findings(mission("(printf \"%é\" level)")) == "PS0332 %é");
}

TEST_CASE("properties observe, programs do not") {
  auto property = [](const std::string& text) {
    return findings(mission("(label up) (survey)") + "(defproperty p " + text + ")");
  };
  CHECK(property("(always (or (running survey) (called takeoff) (ended takeoff success)))") == "");
  CHECK(property("(reachable (and (at up) (value battery Low) (occurs drained)))") == "");
  CHECK(property("(ltl ([] (=> (running survey) (<> (ended survey)))))") == "");
  CHECK(property("(never (running landing))") == "PS0201 landing");
  CHECK(property("(never (ended takeoff landed))") == "PS0211 landed");
  CHECK(property("(never (ended takeoff no_status))") == "PS0211 no_status");
  CHECK(property("(never (occurs full))") == "PS0204 full");
  CHECK(property("(never (at down))") == "PS0207 down");
  CHECK(property("(never (value battery Empty))") == "PS0203 Empty");
  CHECK(property("(present (battery Low) :after (running landing))") == "PS0201 landing");
  CHECK(findings(mission("(^ (running survey))")) == "PS0310 running");
  CHECK(findings(mission("(^ (at up))")) == "PS0310 at");
}

TEST_CASE("the guard of an event is a condition, and goes with no times") {
  const auto guarded = [](const std::string& fields) {
    return findings(kWorld + "(defevent beat " + fields + " :effects (level 1))");
  };
  CHECK(guarded(":guard (> level 0)") == "");
  CHECK(guarded(":guard (nothing 0)") == "PS0202 nothing");
  CHECK(guarded(":guard (running survey)") == "PS0310 running");
  CHECK(guarded(":every [1,5] :guard (> level 0)") == "PS0419 (> level 0)");
}

TEST_CASE("an event that comes by itself leaves time between, and nobody emits it") {
  const std::string set = " :effects (level 1))";
  const auto every = [&](const std::string& interval) {
    return findings(kWorld + "(defevent beat :every " + interval + set);
  };
  CHECK(every("[1,5]") == "");
  CHECK(every("[0,5]") == "");
  CHECK(every("]0,...[") == "");
  CHECK(every("[0,0]") == "PS0416 [0,0]");
  CHECK(every("[5,1]") == "PS0410 [5,1]");
  CHECK(every("[5,5[") == "PS0411 [5,5[");
  CHECK(findings(kWorld + "(defevent beat :every [1,5]" + set +
                 "(defenvironment e :body ((emit beat) (emit drained)))") == "PS0438 beat");
}

TEST_CASE("each of several initial values is checked") {
  const auto enumeration = [](const std::string& init) {
    return findings("(defsv door :states (Closed Open) :init " + init + ")");
  };
  CHECK(enumeration("(Closed Open)") == "");
  CHECK(enumeration("(Closed)") == "");
  CHECK(enumeration("()") == "PS0110 ()");
  CHECK(enumeration("(Closed Ajar)") == "PS0203 Ajar");
  CHECK(enumeration("(Closed Open Closed)") == "PS0417W Closed");
  const auto natural = [](const std::string& init) {
    return findings("(defsv n :min 1 :max 3 :init " + init + ")");
  };
  CHECK(natural("(1 3)") == "");
  CHECK(natural("(1 4)") == natural("4"));
  CHECK(natural("(2 2)") == "PS0417W 2");
}
