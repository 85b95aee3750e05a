#include "tests/support/random/random_model.h"
#include "tests/support/random/seeds.h"

#include "fiacre/print/print.h"
#include "verify/compile/compile.h"
#include "verify/sample/random_runs.h"
#include "verify/state/state_layout.h"
#include "verify/trace/simulator.h"
#include "verify/trace/witness.h"

#include <catch2/catch.hpp>

#include <array>
#include <numeric>
#include <random>

namespace proskill::test::chance_run_test {

namespace {

constexpr int kSteps = 60;

/// Calls `visit` with random models without priorities, with their state layout, and their goals.
/// \return the number of seeds
template <class Visit> int eachModel(Visit visit) {
  const auto [first, end] = seedsOr(0, 400);
  for (auto seed = first; seed < end; ++seed)
    for (const auto& program : {randomModel(seed), randomModelWithData(seed)}) {
      INFO("seed " << seed << '\n' << fiacre::print(program));
      std::vector<verify::Question> questions;
      for (std::size_t i = 0; i < program.properties.size(); ++i) questions.push_back({i});
      auto compiled = verify::compile(program, {}, questions);
      REQUIRE(compiled.has_value());
      if (!compiled->system.hasPriorities)
        visit(verify::withStateLayout(compiled->system), compiled->goals);
    }
  return static_cast<int>(end - first);
}

verify::Odds anyOdds(const verify::System& system, std::minstd_rand& random) {
  verify::Odds odds{std::vector(system.transitions.size(), 1.0),
                    1.0 + static_cast<double>(random() % 8)};
  for (auto& weight : odds.weights)
    if (random() % 4 == 0) weight = 0.01;
  return odds;
}

/// Whether some step is possible now or later.
bool isAnyPossible(const verify::Simulator& simulator, const verify::Concrete& now,
                   std::int64_t date) {
  return std::ranges::any_of(now.since, [&](const auto& enabled) {
    verify::StepLog log;
    return simulator.opportunity(now, enabled.first, date) &&
           simulator.take(now, enabled.first, date, log);
  });
}

/// Repeats a random run in the simulator. \return number of steps
int repeat(const verify::System& system, std::minstd_rand& random) {
  const verify::Enabling enabling(system);
  const verify::Simulator simulator(system, verify::ChanceRun::kTicks);
  verify::ChanceRun run(system, enabling);
  const auto odds = anyOdds(system, random);
  verify::Concrete now = simulator.start();
  std::int64_t date = 0;
  for (int i = 0; i < kSteps; ++i) {
    const auto step = run.step(odds, random);
    if (!step) {
      CHECK((run.failed() || !isAnyPossible(simulator, now, date)));
      return i;
    }
    date = static_cast<std::int64_t>(run.moment().now);
    REQUIRE(simulator.mayWait(now, date));
    REQUIRE(simulator.isRipe(now, *step, date));
    REQUIRE(std::equal(now.state.begin(), now.state.end(), run.before()));
    verify::StepLog log;
    auto next = simulator.take(now, *step, date, log);
    REQUIRE(next);
    REQUIRE(next->state == run.moment().state);
    REQUIRE(log.events == run.events());
    now = std::move(*next);
  }
  return kSteps;
}

} // namespace

TEST_CASE("what chance decides is possible in the simulator, at the same dates") {
  std::minstd_rand random(7);
  int steps = 0;
  const int seeds = eachModel(
      [&](const verify::System& system, const auto&) { steps += repeat(system, random); });
  CHECK(steps > 10 * seeds);
}

TEST_CASE("a run of chance that reaches a goal shows it, and is the same each time") {
  int found = 0;
  const int seeds =
      eachModel([&](const verify::System& system, const std::vector<verify::Goal>& goals) {
        std::vector<std::size_t> all(goals.size());
        std::iota(all.begin(), all.end(), 0);
        const verify::Options options;
        verify::LimitWatch limits(options);
        const verify::Enabling enabling(system);
        const verify::Reductions none;
        const fiacre::Provenance provenance;
        const verify::Witness witness(system, none, provenance, limits);
        std::array<std::vector<verify::Steps>, 2> runs;
        for (auto& shown : runs)
          verify::RandomRuns(system, enabling, goals, all, limits)
              .search(200, [&](std::size_t goal, const verify::Evidence& evidence) {
                CHECK(witness.refutation(goals[goal], evidence) == "");
                shown.push_back(evidence.steps);
                return true;
              });
        CHECK(runs[0] == runs[1]);
        found += static_cast<int>(runs[0].size());
      });
  CHECK(found > seeds);
}

} // namespace proskill::test::chance_run_test
