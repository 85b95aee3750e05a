#include "tests/analysis/findings.h"

#include <catch2/catch.hpp>

using proskill::test::findings;
using proskill::test::kWorld;
using proskill::test::mission;

TEST_CASE("a condition is true or false") {
  CHECK(findings(mission("(^ true) (while false (survey))")) == "");
  CHECK(findings(mission("(^ battery)")) == "PS0301 battery");
  CHECK(findings(mission("(^ ready)")) == "PS0212 ready");
  CHECK(findings(mission("(if takeoff.status (survey))")) == "PS0301 takeoff.status");
  CHECK(findings(mission("(while (+ level 1) (survey))")) == "PS0301 (+ level 1)");
  CHECK(findings(mission("(^ (and (level 1) level))")) == "PS0301 level");
  CHECK(findings(mission("(^ (not battery))")) == "PS0301 battery");
}

TEST_CASE("both sides of a comparison have the same type") {
  CHECK(findings(mission("(^ (= battery 3))")) == "PS0303 (= battery 3)");
  CHECK(findings(mission("(^ (= battery camera))")) == "PS0303 (= battery camera)");
  CHECK(findings(mission("(^ (= level battery))")) == "PS0303 (= level battery)");
  CHECK(findings(mission("(^ (/= takeoff.status battery))")) == "PS0211 battery");
  CHECK(findings(mission("(^ (= takeoff.status takeoff.res))")) ==
        "PS0303 (= takeoff.status takeoff.res)");
  CHECK(findings(mission("(^ (= takeoff.status 1))")) == "PS0303 (= takeoff.status 1)");
  CHECK(findings(mission("(^ (= takeoff.status survey.status))")) == "");
  CHECK(findings(mission("(^ (= (level 1) (level 2)))")) == "PS0303 (= (level 1) (level 2))");
  CHECK(findings(mission("(^ (= battery \"Good\"))")) == "PS0303 (= battery \"Good\")");
  CHECK(findings(mission("(^ (battery 3))")) == "PS0302 3");
}

TEST_CASE("only naturals are ordered and added") {
  CHECK(findings(mission("(^ (< level 2)) (^ (>= (+ level 1) (- 3 level)))")) == "");
  CHECK(findings(mission("(^ (< battery 2))")) == "PS0304 battery");
  CHECK(findings(mission("(^ (> (+ battery 1) 2))")) == "PS0304 battery");
  CHECK(findings(mission("(^ (< level 1.5))")) == "PS0304 1.5");
  CHECK(findings(mission("(^ (= level -1))")) == "PS0304 -1");
  CHECK(findings(mission("(^ (> takeoff.status 1))")) == "PS0304 takeoff.status");
}

TEST_CASE("effects set what the variable can be") {
  auto effects = [](const std::string& text) {
    return findings(kWorld + "(defevent e :effects " + text + ")");
  };
  CHECK(effects("((battery Low) (level (+ level 1)))") == "");
  CHECK(effects("(battery 1)") == "PS0302 1");
  CHECK(effects("(battery camera)") == "PS0302 camera");
  CHECK(effects("(level battery)") == "PS0302 battery");
  CHECK(effects("(level 4)") == "PS0305 4");
  CHECK(effects("((level 1) (battery Low) (level 2))") == "PS0414 level");
}

TEST_CASE("a natural has the numbers of its domain") {
  CHECK(findings("(defsv n :init 3 :min 3 :max 3)") == "");
  CHECK(findings("(defsv n :init 0 :min 1 :max 3)") == "PS0305 0");
  CHECK(findings("(defsv n :init 4 :min 1 :max 3)") == "PS0305 4");
  CHECK(findings("(defsv n :init 2 :min 3 :max 1)") == "PS0307 1");
  CHECK(findings("(defsv n :init 0 :min 0 :max 65535)") == "");
  CHECK(findings("(defsv n :init 0 :min 0 :max 65536)") == "PS0308 65536");
  CHECK(findings("(defsv n :init 0 :min 0 :max 9223372036854775807)") ==
        "PS0308 9223372036854775807");
  CHECK(findings("(defsv n :init 1.5 :min 0 :max 3)") == "PS0304 1.5");
  CHECK(findings("(defsv n :init 1 :min -1 :max 3)") == "PS0304 -1");
  CHECK(findings("(defsv n :init Low :min 0 :max 3)") == "PS0212 Low");
  CHECK(findings(mission("(^ (level 0))")) == "PS0305 0");
  CHECK(findings(mission("(^ (= level 4))")) == "PS0305 4");
  CHECK(findings(mission("(^ (< level 4))")) == "");
}

TEST_CASE("an enumeration has its values") {
  CHECK(findings("(defsv s :states (A B) :init C)") == "PS0203 C");
  CHECK(findings("(defsv s :states (A B) :init 1)") == "PS0306 1");
  CHECK(findings("(defsv s :states (A B) :init A :transitions :all)") == "");
  CHECK(findings("(defsv s :states (A B) :init A :transitions ((A B) (B C) (D A)))") ==
        "PS0203 C, PS0203 D");
}

TEST_CASE("an input whose type is a state variable has its values in conditions and effects") {
  auto skill = [](const std::string& fields) {
    return findings(
        "(defsv room :states (Hall Attic) :init Hall) (defsv level :init 0 :min 0 :max 3)"
        "(defsv lamp :states (On Off) :init On)"
        "(defskill s :input ($to room $by level) " +
        fields + " :action (x $to $by)) (defskill m :body ((s to Hall by 2)))");
  };
  CHECK(skill(":precondition (a (/= $to room) b (room $to) c (= Hall $to) d (< $by 2))") == "");
  CHECK(skill(":success ok (:effects ((room $to) (level (+ level $by))))") == "");
  CHECK(skill(":invariant (i (:guard (= $to Cellar)))") == "PS0203 Cellar");
  CHECK(skill(":start (lamp $to)") == "PS0302 $to");
  CHECK(skill(":start (lamp $by)") == "PS0302 $by");
  CHECK(skill(":start (level $to)") == "PS0302 $to");
  CHECK(skill(":precondition (a (= $to lamp))") == "PS0303 (= $to lamp)");
  CHECK(skill(":precondition (a (> $to 1))") == "PS0304 $to");
  CHECK(skill(":precondition (a (= $by 7))") == "PS0305 7");
  CHECK(skill(":precondition (a (room $from))") == "PS0208 from");
}

TEST_CASE("an input that is a truth value is a condition") {
  auto skill = [](const std::string& fields) {
    return findings(
        "(defsv door :states (Open Shut) :init Open) (defsv level :init 0 :min 0 :max 3)"
        "(defskill s :input ($a bool $b bool $n nat $by level) " +
        fields + ") (defskill m :body ((s a true b false n 1 by 2)))");
  };
  auto body = [&](const std::string& text) { return skill(":body (" + text + ")"); };
  CHECK(skill(":precondition (p $a q (=> $b (door Open)) r true) :start (door Shut) :action (x)") ==
        "");
  CHECK(skill(":invariant (i (:guard $a)) :success ok (:postcondition $b) :action (x)") == "");
  CHECK(body("(if $a (^ $b) elseif (not $a) (^ (and $a (door Open)) :timeout 1))") == "");
  CHECK(body("(while (<=> $a (door Open)) (^ 1)) (do (^ 1) until (or $a $b))") == "");
  CHECK(body("(if (= $a $b) (^ 1)) (if (/= $a true) (^ 1)) (if (= false $b) (^ 1))") == "");
  CHECK(body("(^ (= $a (door Open)))") == "PS0303 (= $a (door Open))");
  CHECK(body("(^ (= $a door))") == "PS0303 (= $a door)");
  CHECK(body("(^ (= $a 1))") == "PS0303 (= $a 1)");
  CHECK(body("(^ (= $by true))") == "PS0303 (= $by true)");
  CHECK(body("(^ (= $n true))") == "PS0309 $n");
  CHECK(body("(^ (< $a 1))") == "PS0304 $a");
  CHECK(body("(^ (door $a))") == "PS0302 $a");
  CHECK(body("(set (door $a))") == "PS0302 $a");
  CHECK(body("(^ $by)") == "PS0301 $by");
  CHECK(body("(if (and $a $n) (^ 1))") == "PS0309 $n");
}

TEST_CASE("a condition is compared by an equivalence") {
  const std::string world = "(defsv door :states (Open Shut) :init Open) ";
  const auto found = proskill::test::diagnose(
      world + "(defskill s :input ($a bool) :body ((^ (= $a (door Open))))) "
              "(defskill m :body ((s a true)))");
  REQUIRE(found.size() == 1);
  CHECK(found[0].message == "a truth value cannot be compared with a condition");
}

TEST_CASE("only skills have inputs") {
  const std::string room = "(defsv room :states (Hall Attic) :init Hall) ";
  CHECK(findings(room + "(defevent e :effects (room $to))") == "PS0311 $to");
  CHECK(findings(room + "(defproperty p (never (room $to)))") == "PS0311 $to");
  CHECK(findings(room + "(defenvironment e :body ((^ (room $to))))") == "PS0311 $to");
  CHECK(findings(room + "(defenvironment e :body ((^ $fast)))") == "PS0311 $fast");
}

TEST_CASE("other parameters are passed on, not tested") {
  auto body = [](const std::string& text) {
    return findings(kWorld + "(defskill s :input ($p nat) :body (" + text +
                    ")) (defskill m :body ((s p 1)))");
  };
  CHECK(body("(takeoff height $p duration 0) (printf \"%d\" $p)") == "");
  CHECK(body("(^ (> $p 1))") == "PS0309 $p");
  CHECK(body("(^ $p)") == "PS0309 $p");
  CHECK(body("(set (level $p))") == "PS0309 $p");
  CHECK(body("(takeoff height $q duration 0)") == "PS0208 q");
}
