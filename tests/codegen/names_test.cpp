#include "codegen/plan/unique_names.h"
#include "tests/codegen/model_of.h"

#include <catch2/catch.hpp>

using namespace proskill;
using Catch::Contains;

TEST_CASE("a thing has one name, the same whenever it is asked for") {
  codegen::UniqueNames namer;
  CHECK(namer.of("skill", "takeoff") == "takeoff");
  CHECK(namer.of("event", "takeoff") == "takeoff_");
  CHECK(namer.of("value", "takeoff") == "takeoff__");
  CHECK(namer.of("skill", "takeoff") == "takeoff");
}

TEST_CASE("parts that join to the same name stay different things") {
  codegen::UniqueNames namer;
  CHECK(namer.of("tag", {"a", "success", "b", "postcondition"}) == "a_success_b_postcondition");
  CHECK(namer.of("tag", {"a", "success", "b_postcondition"}) == "a_success_b_postcondition_");
}

TEST_CASE("words that Fiacre reserves, its patterns' too, get an underscore") {
  codegen::UniqueNames namer;
  CHECK(namer.of("variable", "process") == "process_");
  CHECK(namer.of("variable", "within") == "within_");
  REQUIRE(namer.renamings().size() == 2);
  CHECK(namer.renamings()[0].preferred == "process");
}

TEST_CASE("a program may use the words that the generator uses itself") {
  const auto model = test::modelOf(R"(
    (defsv skill :states (None root) :init None)
    (defsv main :states (success no_status) :init success)
    (defevent event :effects (skill root))
    (defskill state :action (state) :success (interrupted (:effects (main no_status))))
    (defskill invariant_active :body ((state) (if (= state.status success) (set (skill None))))))");
  const auto text = test::printed(model);
  CHECK_THAT(text, Contains("type sv_skill is union None_ | root_ end"));
  CHECK_THAT(text, Contains("process event_event_automata [event_: sync]"));
  CHECK_THAT(text, Contains("skill_ := root_;"));
  CHECK_THAT(text, Contains("skill[state_].caller := invariant_active_;"));
  CHECK_THAT(model.fiacre.comment, Contains("`skill` is `skill_` here"));
}

TEST_CASE("a value keeps its name unless two enumerations have it") {
  const auto text = test::printed(test::modelOf(R"(
    (defsv gps :states (Lost Valid) :init Lost)
    (defsv map :states (Valid Old) :init Old)
    (defevent fix :effects ((gps Valid) (map Valid))))"));
  CHECK_THAT(text, Contains("type sv_gps is union Lost | gps_Valid end"));
  CHECK_THAT(text, Contains("type sv_map is union map_Valid | Old end"));
  CHECK_THAT(text, Contains("gps := gps_Valid;\n    map := map_Valid;"));
}
