#include "tests/support/random/random_model.h"
#include "tests/tina/model.h"
#include "tina/names.h"
#include "verify/compile/compile.h"
#include "verify/graph/tina_names.h"
#include "verify/state/state_layout.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

verify::System systemOf(const fiacre::Program& program) {
  auto compiled = verify::compile(program, {}, {});
  if (!compiled) FAIL(compiled.error().message);
  return withStateLayout(std::move(compiled->system));
}

} // namespace

TEST_CASE("names of Tina lead back to instances, states and variables, in both spellings") {
  const auto parsed = test::model(R"(
process A_b is states s_1, t from s_1 to t
process A is states s var x_y: 0..3 := 0 from s to s
component main is
var all: array 2 of 0..1 := [0, 0]
par * in A_b || A || A_b end
main)");
  const auto system = systemOf(parsed.program);
  const tina::Names names(system, "main");
  using Parts = std::vector<tina::Names::Part>;
  CHECK(names.transition("A__b_2_t0") == Parts{{2, 0}});
  CHECK(names.transition("A_b_2_t12") == Parts{{2, 12}});
  CHECK(names.transition("A__b_2_t1_A_1_t5_A__b_1_t0") == Parts{{0, 0}, {1, 5}, {2, 1}});
  CHECK(names.transition("{A_1_t5}") == Parts{{1, 5}});
  for (const auto* odd : {"", "A", "A_1", "A_1_t", "A_1_tx", "A_3_t0", "A_1_t0_", "A_1_t0x"})
    CHECK_FALSE(names.transition(odd).has_value());
  CHECK(names.partsWithin("obs_1_t3_A_1_t5_other_2_t0") == Parts{{1, 5}});
  CHECK(names.partsWithin("A__b_2_t1_obs_1_t0_A_1_t5") == Parts{{1, 5}, {2, 1}});
  CHECK(names.partsWithin("obs_1_t3").empty());
  REQUIRE(names.place("A__b_2_ss__1").has_value());
  CHECK(names.place("A__b_2_ss__1")->instance == 2);
  CHECK(names.place("A_b_2_st")->location == 1);
  CHECK_FALSE(names.place("A__b_2_ss_1").has_value());
  REQUIRE(names.variable("A_1_vx__y").has_value());
  CHECK(system.cells[*names.variable("A_1_vx__y")].name == "A_1.x_y");
  REQUIRE(names.variable("{main_1_vall.at[1]}").has_value());
  CHECK(system.cells[*names.variable("{main_1_vall.at[1]}")].name == "all[1]");
}

TEST_CASE("every name that is written of a random model is read back as what it was") {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto program = test::randomModel(seed);
    const auto system = systemOf(program);
    const tina::Names names(system, program.main);
    for (verify::InstanceId i = 0; i < system.instances.size(); ++i)
      for (std::uint32_t at = 0; at < system.instances[i].locations.size(); ++at) {
        const auto place = names.place(tinaPlace(system, i, at));
        REQUIRE(place.has_value());
        CHECK(place->instance == i);
        CHECK(place->location == at);
      }
    for (verify::TransitionId id = 0; id < system.transitions.size(); ++id) {
      verify::StepLog log;
      const auto& parts = system.transitions[id].parts;
      for (std::uint32_t i = 0; i < parts.size(); ++i) log.leaves.push_back(i);
      const auto read = names.transition(tinaTransition(system, id, log));
      REQUIRE(read.has_value());
      REQUIRE(read->size() == parts.size());
      for (std::uint32_t i = 0; i < parts.size(); ++i)
        CHECK((*read)[i] == tina::Names::Part{system.paths[parts[i]].instance, i});
    }
  }
}
