#include "tests/codegen/model_of.h"

#include <catch2/catch.hpp>

namespace proskill::test::inputs {

namespace {

const std::string kRooms = R"((defsv room :states (Hall Attic) :init Hall)
(defsv floor :init 0 :min 0 :max 2)
)";

std::string textOf(const std::string& text) { return printed(modelOf(kRooms + text)); }

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("a call sets the inputs that conditions and effects read") {
  const auto model = textOf(R"((defskill go :input ($to room $speed float) :action (go $to $speed)
  :success there (:effects (room $to)))
(defskill mission :body ((go to Attic speed 1.5)))
)");
  CHECK(contains(model, "go_to: sv_room := Hall"));
  CHECK(contains(
      model,
      "skill[go].caller := mission;\n    skill[go].status := no_status;\n    go_to := Attic"));
  CHECK(contains(model, "room := go_to"));
  CHECK_FALSE(contains(model, "go_speed"));
}

TEST_CASE("an input that only goes to the platform is no variable") {
  const auto model = textOf(R"((defskill go :input ($to room) :action (go $to))
(defskill mission :body ((go to Attic)))
)");
  CHECK_FALSE(contains(model, "go_to"));
}

TEST_CASE("inputs are passed on to those that are read") {
  const auto model = textOf(
      R"((defskill climb :input ($by floor) :action (climb) :success up (:effects (floor (+ floor $by))))
(defskill visit :input ($up floor $unused floor) :body ((climb by $up)))
(defskill mission :body ((visit up 1 unused 2) (visit up 2 unused 2)))
)");
  CHECK(contains(model, "visit_up := 1"));
  CHECK(contains(model, "visit_up := 2"));
  CHECK(contains(model, "climb_by := visit_up"));
  CHECK_FALSE(contains(model, "visit_unused"));
}

TEST_CASE("the most general caller passes all values") {
  const auto model = textOf(
      "(defskill go :input ($to room) :action (go $to) :success there (:effects (room $to)))\n");
  CHECK(contains(model, "go_to := Hall\n    []\n        go_to := Attic"));
}

TEST_CASE("a truth value that conditions read is set by the call and passed on") {
  const auto model = textOf(R"((defskill go :input ($fast bool $loud bool) :action (go $loud)
  :precondition (slow (not $fast)) :success there)
(defskill visit :input ($fast bool) :body ((go fast $fast loud true)))
(defskill mission :body ((visit fast true) (visit fast false)))
)");
  CHECK(contains(model, "go_fast: bool := false"));
  CHECK(contains(model, "visit_fast := true"));
  CHECK(contains(model, "visit_fast := false"));
  CHECK(contains(model, "go_fast := visit_fast"));
  CHECK(contains(model, "if (not go_fast) then"));
  CHECK_FALSE(contains(model, "go_loud"));
}

TEST_CASE("the most general caller passes both truth values") {
  const auto model = textOf("(defskill go :input ($fast bool) :precondition (slow (= $fast false))"
                            " :action (go $fast) :success there)\n");
  CHECK(contains(model, "go_fast := false\n    []\n        go_fast := true"));
  CHECK(contains(model, "if (go_fast = false) then"));
}

TEST_CASE("an input as the target of a move is tested for each of its values") {
  const auto model = textOf(R"((defsv lid :states (Open Shut) :init Shut :transitions ((Shut Open)))
(defskill turn :input ($to lid) :action (turn) :success ok (:effects (lid $to)))
(defskill mission :body ((turn to Open)))
)");
  CHECK(contains(model, "if ((turn_to = Shut) and (lid = Open)) then"));
}

TEST_CASE("a name that is taken gives way") {
  const auto model = textOf(R"((defsv go_to :states (A B) :init A)
(defskill go :input ($to room) :action (go $to) :success there (:effects (room $to)))
(defskill mission :body ((go to Attic) (set (go_to B))))
)");
  CHECK(contains(model, "go_to_ := Attic"));
}

} // namespace proskill::test::inputs
