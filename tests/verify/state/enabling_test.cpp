#include "tests/support/random/random_model.h"

#include "verify/compile/compile.h"
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
