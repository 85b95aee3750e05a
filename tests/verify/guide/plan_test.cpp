#include "fiacre/syntax/parse.h"
#include "verify/compile/compile.h"
#include "verify/guide/plan_progress.h"
#include "verify/refine/plan_search.h"
#include "verify/state/evaluate.h"
#include "verify/state/run.h"
#include "verify/state/state_layout.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

#include <array>

namespace proskill::test::plan_test {

namespace {

using verify::PlanProgress;
using verify::Steps;

/// Four walkers that each take five steps, or go back, and a process of one location that knocks.
const std::string kWalkers = [] {
  std::string text = "process P is states a, b, c, d, e, f ";
  for (const std::string step : {"ab", "bc", "cd", "de", "ef"})
    text += std::string("from ") + step[0] + " wait [1,3]; select to " + step[1] + " [] to a end ";
  return text + "process Knock is states k from k wait [0,...[; to k "
                "component main is par * in P || P || P || P || Knock end main ";
}();

struct Model {
  explicit Model(const std::string& condition)
      : parsed(fiacre::parse(kWalkers + "property p is absent " + condition + " assert p")),
        compiled(*verify::compile(parsed.program, parsed.provenance, {{0}}, &limits)),
        whole(verify::withStateLayout(compiled.system)) {
    REQUIRE(parsed.problems.empty());
  }

  /// The steps of one walker from its first location on, each to the next location.
  [[nodiscard]] Steps walk(std::size_t instance) const {
    Steps steps;
    auto state = verify::initialState(whole);
    const auto location = whole.instances[instance].location;
    while (verify::readCell(whole, location, state.data()) < 5)
      steps.push_back(ahead(instance, state));
    return steps;
  }
  /// The step of a process of one location.
  [[nodiscard]] verify::TransitionId knock() const {
    for (verify::TransitionId i = 0; i < whole.transitions.size(); ++i)
      if (whole.paths[whole.transitions[i].parts.front()].instance == 4) return i;
    FAIL("no step");
    return 0;
  }

  verify::Options options;
  verify::LimitWatch limits{options};
  fiacre::Parsed parsed;
  verify::Compiled compiled;
  verify::System whole;

private:
  /// Takes the step of the instance to its next location.
  [[nodiscard]] verify::TransitionId ahead(std::size_t instance,
                                           std::vector<verify::Word>& state) const {
    const auto location = whole.instances[instance].location;
    const auto now = verify::readCell(whole, location, state.data());
    for (verify::TransitionId i = 0; i < whole.transitions.size(); ++i) {
      if (whole.paths[whole.transitions[i].parts.front()].instance != instance ||
          !verify::isEnabled(whole, i, state.data()))
        continue;
      auto next = state;
      verify::StepLog log;
      if (verify::fire(whole, i, next.data(), log) != verify::Outcome::Done ||
          verify::readCell(whole, location, next.data()) != now + 1)
        continue;
      state = next;
      return i;
    }
    FAIL("no step leads on");
    return 0;
  }
};

const std::string kEnd = "(main/1/state f)";

Steps operator+(Steps first, const Steps& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

} // namespace

TEST_CASE("instances follow a plan in any order among each other, and steps aside count") {
  const Model model(kEnd);
  const Steps one = model.walk(0);
  const Steps other = model.walk(1);
  PlanProgress progress(model.whole, one + other);
  CHECK(progress.add({}) == 10);
  progress.expand(0);
  CHECK(progress.add(std::array{other[0]}) == 9);         // node 1
  CHECK(progress.add(std::array{one[0], other[0]}) == 8); // 2
  CHECK(progress.add(std::array{other[1]}) == 11);        // 3: not its turn
  CHECK(progress.add(std::array{model.walk(2)[0]}) == 10);
  progress.expand(2);
  CHECK(progress.add(std::array{one[1]}) == 7);
  progress.expand(1);
  CHECK(progress.add(std::array{one[1]}) == 10);
}

TEST_CASE("events of a plan wait for what comes before them") {
  const Model model(kEnd);
  const Steps walk = model.walk(0);
  PlanProgress progress(model.whole, Steps{walk[0], model.knock(), walk[1]});
  CHECK(progress.add({}) == 3);
  progress.expand(0);
  CHECK(progress.add(std::array{model.knock()}) == 4);                   // too early
  CHECK(progress.add(std::array{walk[0], walk[1], model.knock()}) == 0); // node 2
  progress.expand(2);
  CHECK(progress.add(std::array{model.knock()}) == 0); // the plan needs no other
}

TEST_CASE("a search along a plan finds what others delay") {
  const Model model("((main/1/state f) and (main/2/state f))");
  const auto& goals = model.compiled.goals;
  const std::function<bool(verify::Reduction)> takes = [](verify::Reduction) { return true; };
  verify::Options options;
  verify::LimitWatch limits{options};
  verify::PlanSearch search(model.compiled.system, model.whole, model.parsed.provenance, takes,
                            limits, goals, {0});
  const auto searched = [&](const Steps& plan, std::uint64_t classes) {
    verify::Bits decided;
    verify::Exploration counts;
    std::size_t replayed = 0;
    search.follow(plan, classes, decided, counts, [&](std::size_t i, const verify::Evidence* run) {
      verify::Witness witness(model.whole, {}, model.parsed.provenance, limits);
      if (witness.refutation(goals[i], *run).empty()) ++replayed;
      return true;
    });
    CHECK(decided.count() == replayed);
    return replayed;
  };
  CHECK(searched(model.walk(0) + model.walk(1), 25) == 1);
  CHECK(searched(model.walk(2), 25) == 0); // it leads elsewhere, and proves nothing
}

} // namespace proskill::test::plan_test
