#include "tests/support/models.h"
#include "verify/trace/simulation.h"

#include <catch2/catch.hpp>

using namespace proskill;
using namespace proskill::test;

namespace {

/// Owns what a simulation refers to.
struct Run {
  explicit Run(const Model& of) : model(of), simulation(started()) {}

  verify::Simulation started() {
    auto made = verify::Simulation::start(model.program(), provenance);
    REQUIRE(made);
    return std::move(*made);
  }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& choice : simulation.choices()) all.push_back(choice.step.transitions.at(0));
    return all;
  }

  const Model& model;
  fiacre::Provenance provenance;
  verify::Simulation simulation;
};

Model oneOf(fiacre::Interval first, fiacre::Interval second) {
  Model model;
  model.add(process("p", {"a", "b"}, {from("a", {waitIn(first), to("b")})}));
  model.add(process("q", {"a", "b"}, {from("a", {waitIn(second), to("b")})}));
  return model;
}

} // namespace

TEST_CASE("a simulation offers what may come next, what has to happen soonest first") {
  auto model = oneOf({2, 9}, {1, 5});
  Run run(model);
  CHECK(run.names() == std::vector<std::string>{"q_1_t0", "p_1_t0"});
  auto choices = run.simulation.choices();
  CHECK(choices[0].earliest == 1 * choices[0].scale);
  CHECK(choices[0].latest == 5 * choices[0].scale);
  // the other must come before the first one's deadline, too
  CHECK(choices[1].earliest == 2 * choices[1].scale);
  CHECK(choices[1].latest == 5 * choices[1].scale);
}

TEST_CASE("what cannot come before something else has to happen is not offered") {
  auto model = oneOf({6, 9}, {1, 5});
  Run run(model);
  CHECK(run.names() == std::vector<std::string>{"q_1_t0"});
  run.simulation.take(0);
  CHECK(run.names() == std::vector<std::string>{"p_1_t0"});
  auto choice = run.simulation.choices()[0];
  CHECK(choice.earliest == 6 * choice.scale);
  CHECK(choice.step.date == choice.earliest);
}

TEST_CASE("a date that is not reached is passed; one that nothing can pass offers nothing") {
  auto model = oneOf({.lower = 2, .upper = 5, .lowerOpen = true}, {0, std::nullopt});
  Run run(model);
  auto choices = run.simulation.choices();
  REQUIRE(choices.size() == 2);
  CHECK(choices[0].afterEarliest);
  CHECK(choices[0].step.date > choices[0].earliest);
  CHECK_FALSE(choices[1].bounded);
  auto empty = oneOf({.lower = 2, .upper = 5, .lowerOpen = true}, {0, 2});
  CHECK(Run(empty).names() == std::vector<std::string>{"q_1_t0"});
}

TEST_CASE("what is taken back can be chosen otherwise") {
  auto model = oneOf({2, 9}, {1, 5});
  Run run(model);
  const auto before = run.names();
  run.simulation.take(1);
  CHECK(run.names() == std::vector<std::string>{"q_1_t0"});
  CHECK(run.simulation.undo());
  CHECK(run.names() == before);
  CHECK_FALSE(run.simulation.undo());
  run.simulation.take(0);
  run.simulation.take(0);
  CHECK(run.names().empty());
}

TEST_CASE(
    "a step can be taken as late as it may come, and just before a date that it does not reach") {
  auto model = oneOf({2, 9}, {1, 5});
  Run run(model);
  const auto scale = run.simulation.choices()[0].scale;
  CHECK(run.simulation.take(1, verify::When::Late) == 5 * scale);
  auto open = oneOf({.lower = 2, .upper = 5, .upperOpen = true}, {9, 9});
  Run other(open);
  CHECK(other.simulation.take(0, verify::When::Late) == 5 * scale - 1);
  auto unbounded = oneOf({2, std::nullopt}, {9, std::nullopt});
  Run third(unbounded);
  CHECK(third.simulation.take(0, verify::When::Late) == 2 * scale);
}
