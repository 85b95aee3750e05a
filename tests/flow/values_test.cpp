#include "tests/flow/analysed.h"

#include <catch2/catch.hpp>

using proskill::test::Analysed;

namespace {

const std::string kLight = "(defsv light :states (Off On Broken) :init Off)\n"
                           "(defskill flash :action (flash) :failure dark)\n";

} // namespace

TEST_CASE("A body goes on with what it has set") {
  Analysed flow(kLight + R"((defskill mission :body ((set (light On)) (printf "%s" light)
                              (if (light On) (flash) else (set (light Broken))))))");
  CHECK(flow.at("(set (light On))", "light") == "Off");
  CHECK(flow.at("(flash)", "light") == "On");
  CHECK_FALSE(flow.reaches("(set (light Broken))"));
  CHECK(flow.ever("light") == "Off or On");
}

TEST_CASE("An event may strike between any two steps") {
  Analysed flow(kLight + R"((defevent breaks :effects (light Broken))
(defskill mission :body ((set (light On)) (if (light On) (set (light Off)) (flash)))))");
  CHECK(flow.at("(if", "light") == "On or Broken");
  CHECK(flow.at("(set (light Off))", "light") == "On or Broken");
}

TEST_CASE("An input that is a truth value has those that calls pass") {
  const std::string skill = kLight + R"((defskill shine :input ($bright bool) :body
  ((if $bright (set (light On)) else (set (light Broken)))))
)";
  Analysed one(skill + "(defskill mission :body ((shine bright true)))");
  CHECK(one.ever("light") == "Off or On");
  CHECK_FALSE(one.reaches("(set (light Broken))"));
  Analysed both(skill + R"((defskill pass :input ($it bool) :body ((shine bright $it)))
(defskill mission :body ((shine bright true) (pass it false))))");
  CHECK(both.ever("light") == "Off, On or Broken");
  Analysed equal(kLight + R"((defskill shine :input ($a bool $b bool) :body
  ((if (= $a $b) (set (light On))) (if (/= $a true) (set (light Broken)))))
(defskill mission :body ((shine a false b false))))");
  CHECK(equal.reaches("(set (light On))"));
  CHECK(equal.reaches("(set (light Broken))"));
}

TEST_CASE("Within a step nothing comes in between") {
  Analysed flow(kLight + R"((defevent breaks :effects (light Broken))
(defskill mission :body ((^ (light Broken) :effects (light On)) (flash))))");
  CHECK(flow.at("(flash)", "light") == "On or Broken");
  Analysed tested(kLight + R"((defevent breaks :effects (light Broken))
(defskill mission :precondition (off (light Off)) :start (light On)
  :body ((if (light Broken) (flash)))))");
  CHECK(tested.at("(if", "light") == "On or Broken");
}

TEST_CASE("The status of a call is what the callee can return") {
  Analysed flow(kLight + R"((defskill mission :body
    ((if (= flash.status no_status) (printf "before"))
     (flash)
     (if (= flash.status success) (printf "good")
      elseif (= flash.status failure) (printf "bad")
      elseif (= flash.status no_status) (printf "refused")
      else (printf "stopped")))))");
  CHECK(flow.at("(if (= flash.status no", "flash.status") == "no_status");
  CHECK(flow.at("(if (= flash.status s", "flash.status") == "success or failure");
  CHECK(flow.reaches("(printf \"bad\")"));
  CHECK_FALSE(flow.reaches("(printf \"refused\")"));
  CHECK_FALSE(flow.reaches("(printf \"stopped\")"));
}

TEST_CASE("A skill that can be refused, stopped or interrupted says so in its status") {
  Analysed flow(R"((defsv light :states (Off On) :init Off)
(defevent switch_on :effects (light On))
(defevent switch_off :effects (light Off))
(defskill shoot :precondition (lit (light On)) :invariant (still_lit (:guard (light On)))
  :interrupt (:effects (light Off)) :action (shoot))
(defskill mission :body ((shoot) (if (= shoot.status success) (printf "done")))))");
  CHECK(flow.at("(if", "shoot.status") == "no_status, success, failed_inv or interrupted");
}

TEST_CASE("Branches interfere with each other, and what follows sees what each has left") {
  Analysed flow(kLight + R"((defskill mission :body
    ((// ((set (light On)) (printf "a") (set (light Broken)))
         ((if (light Off) (printf "still off"))))
     (if (light Broken) (printf "joined")))))");
  CHECK(flow.at("(if (light Off)", "light") == "Off, On or Broken");
  CHECK(flow.at("(if (light Broken)", "light") == "Broken");
}

TEST_CASE("Numbers are counted, and saturate") {
  Analysed flow(R"((defsv n :init 0 :min 0 :max 3)
(defskill mission :body ((set (n (+ n 1))) (printf "one") (while (< n 3) (set (n (+ n 2))))
  (if (= n 3) (printf "three") else (printf "other")))))");
  CHECK(flow.at("(printf \"one\")", "n") == "1");
  CHECK(flow.at("(if", "n") == "3");
  CHECK_FALSE(flow.reaches("(printf \"other\")"));
}

TEST_CASE("A large domain is cut where the program looks") {
  Analysed flow(R"((defsv n :init 500 :min 0 :max 100000)
(defskill mission :body ((while (< n 2000) (set (n (+ n 1)))) (if (> n 1999) (printf "end")
   else (printf "never")))))");
  CHECK(flow.reaches("(printf \"end\")"));
  CHECK_FALSE(flow.reaches("(printf \"never\")"));
}

TEST_CASE("An environment decides which events come, and when") {
  Analysed flow(kLight + R"((defevent breaks :effects (light Broken))
(defevent burns :effects (light On))
(defenvironment quiet :body ((^ (light On)) (emit breaks)))
(defskill mission :body ((if (light Off) (printf "first")) (set (light On)) (if (light On) (flash)))))");
  CHECK(flow.at("(if (light Off)", "light") == "Off");
  CHECK(flow.at("(if (light On)", "light") == "On or Broken");
}

TEST_CASE("A monitor runs beside the mission from the start") {
  Analysed flow(kLight + R"((defskill mission :body ((set (light On)) (if (light Broken) (flash))))
(defskill monitor :monitor t :body ((^ (light On)) (set (light Broken)))))");
  CHECK(flow.at("(if", "light") == "On or Broken");
  CHECK(flow.at("(set (light Broken))", "light") == "On");
}

TEST_CASE("A monitor that is always armed may run again") {
  const std::string watch = kLight + R"((defsv count :init 0 :min 0 :max 2)
(defevent lights :effects (light On)) (defevent dims :effects (light Off))
(defskill mission :body ((^ 1)))
(defskill watch :precondition (lit (light On))
  :body ((if (> count 0) (flash)) (set (count (+ count 1)))) :monitor )";
  CHECK(Analysed(watch + "always)").reaches("(flash)"));
  CHECK_FALSE(Analysed(watch + "t)").reaches("(flash)"));
}

TEST_CASE("Skills of a library may be called by anybody at any time") {
  Analysed flow(R"((defsv light :states (Off On) :init Off)
(defskill on :precondition (off (light Off)) :start (light On) :action (on))
(defskill off :precondition (on (light On)) :start (light Off) :action (off)))");
  CHECK(flow.ever("light") == "Off or On");
}

TEST_CASE("What a stopped skill has left behind is known to its caller") {
  Analysed flow(R"((defsv door :states (Shut Open) :init Shut)
(defsv light :states (Off On) :init Off)
(defevent opens :effects (door Open))
(defskill shine :start (light On) :action (shine) :success done (:effects (light Off)))
(defskill careful :invariant (shut (:guard (door Shut))) :body ((shine)))
(defskill mission :body ((careful) (if (light On) (printf "left on")))))");
  CHECK(flow.at("(if", "light") == "Off or On");
}

TEST_CASE("An event with a guard strikes only where the guard holds") {
  Analysed flow(kLight + R"((defevent breaks :guard (light On) :effects (light Broken))
(defskill mission :body ((printf "off") (if (light Off) (set (light On))) (flash))))");
  CHECK(flow.at("(if", "light") == "Off");
  CHECK(flow.at("(flash)", "light") == "On or Broken");
}
