#include "tests/support/random/random_model.h"
#include "tests/support/random/seeds.h"

#include "fiacre/print/print.h"
#include "verify/compile/compile.h"
#include "verify/state/state_layout.h"
#include "verify/trace/simulator.h"

#include <catch2/catch.hpp>

#include <random>

namespace proskill::test::simulator_test {

namespace {

constexpr int kSteps = 60;

/// Since when each transition has been enabled after a step, by looking at all of them.
verify::EnabledSince enabledAfter(const verify::System& system, const verify::Concrete& before,
                                  verify::TransitionId step, std::int64_t date,
                                  const std::vector<verify::Word>& state) {
  const auto clocked = [&](verify::TransitionId id) {
    const auto unseen = system.transitions[id].unseen;
    return unseen == verify::kNone ? id : unseen;
  };
  verify::EnabledSince all;
  for (verify::TransitionId id = 0; id < system.transitions.size(); ++id) {
    if (!verify::isEnabled(system, id, state.data())) continue;
    const bool goesOn = before.since.contains(clocked(id)) && clocked(id) != clocked(step) &&
                        !verify::disturbs(system, step, clocked(id));
    all.add(id, goesOn ? before.since.at(clocked(id)) : date);
  }
  return all;
}

/// Walks at random, and lets time pass before half of the steps. \return number of steps
int walk(const verify::System& system, std::mt19937_64& random) {
  const verify::Simulator simulator(system, 1);
  verify::Concrete now = simulator.start();
  std::int64_t date = 0;
  for (int i = 0; i < kSteps; ++i) {
    if (random() % 2 == 0 && simulator.mayWait(now, date + 1)) ++date;
    std::vector<verify::TransitionId> ripe;
    for (const auto& [id, since] : now.since)
      if (simulator.isRipe(now, id, date)) ripe.push_back(id);
    if (ripe.empty()) return i;
    const auto step = ripe[random() % ripe.size()];
    verify::StepLog log;
    auto next = simulator.take(now, step, date, log);
    if (!next) return i;
    REQUIRE(next->since == enabledAfter(system, now, step, date, next->state));
    now = std::move(*next);
  }
  return kSteps;
}

} // namespace

TEST_CASE("the simulator knows after each step what is enabled, and since when") {
  std::mt19937_64 random(7);
  int steps = 0;
  const auto [first, end] = seedsOr(0, 400);
  for (auto seed = first; seed < end; ++seed)
    for (const auto& program :
         {randomModel(seed), randomModelWithData(seed), randomModelWithObserver(seed)}) {
      INFO("seed " << seed << '\n' << fiacre::print(program));
      auto compiled = verify::compile(program, {}, {});
      REQUIRE(compiled.has_value());
      steps += walk(verify::withStateLayout(compiled->system), random);
    }
  CHECK(steps > 10 * static_cast<int>(end - first));
}

} // namespace proskill::test::simulator_test
