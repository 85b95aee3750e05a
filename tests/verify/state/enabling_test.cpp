#include "tests/support/random/random_model.h"

#include "verify/compile/compile.h"
#include "verify/explore/explorer.h"
#include "verify/state/constant_steps.h"
#include "verify/state/enabled.h"
#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <catch2/catch.hpp>

#include <random>

using namespace proskill;
using namespace proskill::verify;

namespace {

/// Takes a step that the system allows, time aside. \return whether there is one
bool walk(const System& system, const TransitionSet& enabled, std::mt19937_64& random,
          std::vector<Word>& state) {
  std::vector<TransitionId> all;
  eachIn(enabled, [&](TransitionId transition) { all.push_back(transition); });
  if (all.empty()) return false;
  return fire(system, all[random() % all.size()], state.data()) == Outcome::Done;
}

/// Compares the steps that write constants with those that run their code, along a random walk.
/// \return how many there are in all states
std::size_t compareConstantSteps(const System& system, std::uint64_t seed) {
  const Enabling enabling(system);
  const ConstantSteps constantSteps(system);
  std::mt19937_64 random(seed);
  auto state = initialState(system);
  TransitionSet enabled;
  std::size_t compared = 0;
  for (int step = 0; step < 50; ++step) {
    enabling.compute(state.data(), enabled);
    eachIn(enabled, [&](TransitionId i) {
      if (!constantSteps.contain(i)) return;
      INFO("seed " << seed << ", step " << step << ", transition " << i);
      auto written = state;
      constantSteps.fire(i, written.data());
      auto run = state;
      StepLog log;
      REQUIRE(fire(system, i, run.data(), log) == Outcome::Done);
      REQUIRE(written == run);
      REQUIRE(log.events.empty());
      ++compared;
    });
    if (!walk(system, enabled, random, state)) break;
  }
  return compared;
}

/// The system in which only urgent steps say something about time.
System withoutClocks(System system) {
  for (auto& transition : system.transitions) {
    if (transition.clock == kNone) continue;
    transition.clock = kNone;
    transition.interval = {};
    transition.blocksLater = false;
  }
  for (auto& transition : system.transitions) transition.laterBlockers.clear();
  system.clocks.clear();
  return withStateLayout(std::move(system));
}

/// Compares what a search has noted of states with what is enabled there. \return how many of them
/// are urgent
std::size_t countUrgent(const System& system) {
  Options options;
  options.limits.classes = 500;
  LimitWatch limits(options);
  const std::vector<Goal> none;
  const Reductions nothing;
  Explorer explorer(system, none, nothing, Extrapolation::Maximum, limits);
  REQUIRE(explorer.run().statistics.classes > 0);
  const ZoneGraph& graph = explorer.explored();
  std::vector<Word> state(system.words);
  TransitionSet enabled;
  std::size_t urgent = 0;
  for (StateId i = 0; i < graph.states.size(); ++i) {
    graph.states.read(i, state.data());
    graph.enabling.compute(state.data(), enabled);
    const bool isUrgent = graph.enabling.isUrgent(enabled);
    REQUIRE(graph.timing.at(graph.signatureOf(i)).urgent == isUrgent);
    urgent += isUrgent ? 1 : 0;
  }
  return urgent;
}

/// Compares what is enabled along a random walk with the guards.
std::size_t compareAlongWalk(const System& system, std::uint64_t seed) {
  const Enabling enabling(system);
  std::mt19937_64 random(seed);
  auto state = initialState(system);
  TransitionSet enabled;
  std::size_t compared = 0;
  for (int step = 0; step < 50; ++step) {
    enabling.compute(state.data(), enabled);
    for (TransitionId i = 0; i < system.transitions.size(); ++i, ++compared) {
      INFO("seed " << seed << ", step " << step << ", transition " << i);
      const bool isIn = (enabled[i / 64] >> (i % 64) & 1) != 0;
      REQUIRE(isIn == isEnabled(system, i, state.data()));
    }
    if (!walk(system, enabled, random, state)) break;
  }
  return compared;
}

} // namespace

TEST_CASE("what is enabled in a state are the transitions whose guards hold") {
  std::size_t compared = 0;
  std::size_t tabled = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    auto compiled =
        compile(seed % 2 == 0 ? test::randomModel(seed) : test::randomModelWithData(seed), {}, {});
    REQUIRE(compiled.has_value());
    const System system = withStateLayout(std::move(compiled->system));
    TransitionSet all((system.transitions.size() + 63) / 64);
    for (TransitionId i = 0; i < system.transitions.size(); ++i) insert(all, i);
    tabled += GuardTables(system, all).pay() ? 1 : 0;
    compared += compareAlongWalk(system, seed);
  }
  CHECK(compared > 100'000);
  CHECK(tabled > 200);
}

TEST_CASE("steps that write constants are those that their code takes") {
  std::size_t compared = 0;
  std::size_t others = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    auto compiled =
        compile(seed % 2 == 0 ? test::randomModel(seed) : test::randomModelWithData(seed), {}, {});
    REQUIRE(compiled.has_value());
    const System system = withStateLayout(std::move(compiled->system));
    compared += compareConstantSteps(system, seed);
    const ConstantSteps constantSteps(system);
    for (TransitionId i = 0; i < system.transitions.size(); ++i)
      others += constantSteps.contain(i) ? 0 : 1;
  }
  CHECK(compared > 10'000);
  CHECK(others > 1000);
}

TEST_CASE("a step that an event is about runs its code") {
  System system;
  system.cells.push_back({.name = "place", .high = 1, .mask = 1});
  system.instances.push_back({.location = 0});
  Path path;
  path.code = {{.kind = InstructionKind::To, .last = 1, .event = 7}};
  system.paths = {path};
  system.transitions.resize(2);
  system.transitions[0].parts = {0};
  CHECK_FALSE(ConstantSteps(system).contain(0));
  system.paths[0].code[0].event = kNone;
  CHECK(ConstantSteps(system).contain(0));
  system.transitions[0].events = {7}; // of its port
  CHECK_FALSE(ConstantSteps(system).contain(0));
}

TEST_CASE("a search knows which states are urgent, also without clocks") {
  std::size_t urgent = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    auto compiled = compile(test::randomModel(seed), {}, {});
    REQUIRE(compiled.has_value());
    INFO("seed " << seed);
    urgent += countUrgent(withoutClocks(std::move(compiled->system)));
  }
  CHECK(urgent > 100);
}
