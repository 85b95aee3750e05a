#include "verify/sample/random_runs.h"

#include "verify/model/number_table.h"
#include "verify/sample/detours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>
#include <utility>

namespace proskill::verify {

namespace {

constexpr std::size_t kLongestRun = 600;    ///< steps
constexpr std::uint32_t kMostRepeated = 16; ///< states in a row; then a run is idle
constexpr std::size_t kVisited = 1'024;     ///< a power of two
constexpr std::size_t kMostFruitful = 16;   ///< odds
constexpr std::size_t kMostDiscoveries = 20'000;
constexpr std::size_t kMostBytes = std::size_t{32} << 20; ///< of discoveries
constexpr std::size_t kStart = SIZE_MAX;

/// Bytes of a moment, roughly.
std::size_t bytesOf(const RunMoment& moment, const System& system) {
  return sizeof(Word) * (moment.state.size() + moment.enabled.size()) +
         2 * sizeof(std::size_t) * system.clocks.size();
}

} // namespace

RandomRuns::RandomRuns(const System& of, const Enabling& with, const std::vector<Goal>& all,
                       const std::vector<std::size_t>& which, LimitWatch& watch)
    : system(of),
      limits(watch),
      goals(of, all, which),
      values(of),
      chance(of, with),
      direct(of, with),
      start(chance.moment()),
      visited(kVisited) {
  std::int64_t longest = 1;
  for (const auto& it : of.transitions)
    longest = std::max({longest, it.interval.lower, it.interval.upper.value_or(0)});
  mostDiscoveries = std::min(kMostDiscoveries, kMostBytes / bytesOf(start, of));
  longestTime = static_cast<double>(longest) * ChanceRun::kTicks;
}

void RandomRuns::search(std::uint64_t patience, const OnFound& onFound) {
  const auto until = [&] { return std::max(patience, lastFind / 2) + lastFind; };
  lastFind = taken;
  while (!goals.empty() && taken < until()) run(onFound);
}

void RandomRuns::run(const OnFound& onFound) {
  begin();
  walk(onFound);
  if (foundNew) keepOdds();
}

/// Begins where another run found something new, or at the start.
void RandomRuns::begin() {
  odds = drawOdds();
  from = begun = discoveries.empty() || random() % 8 == 0 ? kStart : pickDiscovery();
  chance.goTo(beginning());
  values.goTo(chance.moment().state.data());
  steps.clear();
  length = 0;
  std::ranges::fill(visited, 0);
  repeated = 0;
  foundNew = false;
}

void RandomRuns::walk(const OnFound& onFound) {
  for (; length < kLongestRun && !isIdle(); ++length) {
    limits.check();
    const auto step = chance.step(odds, random);
    ++taken;
    if (!step) break;
    steps.push_back(*step);
    const auto& now = chance.moment();
    show(goals.reached(*step, chance.before(), now.state.data(), chance.events(),
                       isEmpty(now.enabled)),
         onFound);
    note(*step);
  }
  if (!chance.failed()) return;
  steps.push_back(*chance.failed());
  show(goals.errors(), onFound);
}

/// Notes what is new after a step.
void RandomRuns::note(TransitionId step) {
  const auto kind = values.see(step, chance.moment().state.data());
  if (kind == NewValues::Kind::None) return;
  if (kind == NewValues::Kind::Value) foundNew = true;
  if (begun != kStart) discoveries[begun].uses /= 2;
  if (discoveries.size() < mostDiscoveries) discover();
}

const RunMoment& RandomRuns::beginning() const {
  return from == kStart ? start : discoveries[from].moment;
}

/// Others may begin here. The run goes on from here, too: without its detours, if that is possible.
void RandomRuns::discover() {
  const auto& begin = beginning();
  Steps few = without(detoursOf(system, begin.state, steps, true), steps);
  direct.goTo(begin);
  const bool isShorter =
      few.size() < steps.size() &&
      std::ranges::all_of(few, [&](TransitionId step) { return direct.takeEarly(step); }) &&
      direct.moment().state == chance.moment().state;
  if (isShorter) {
    chance.goTo(direct.moment());
    steps = std::move(few);
  }
  discoveries.push_back({chance.moment(), from, std::move(steps)});
  from = discoveries.size() - 1;
  steps.clear();
}

void RandomRuns::show(const std::vector<std::size_t>& reached, const OnFound& onFound) {
  if (reached.empty()) return;
  const Evidence evidence{stepsSoFar(), {}};
  for (auto goal : std::vector(reached)) {
    if (onFound(goal, evidence)) lastFind = taken;
    goals.remove(goal);
    foundNew = true;
  }
}

Steps RandomRuns::stepsSoFar() const {
  std::vector<const Steps*> parts{&steps};
  for (std::size_t at = from; at != kStart; at = discoveries[at].from)
    parts.push_back(&discoveries[at].steps);
  Steps all;
  for (const auto* part : parts | std::views::reverse) append(all, *part);
  return all;
}

/// Whether the run only repeats what it has done, as after the end of a mission.
bool RandomRuns::isIdle() {
  const std::uint64_t hash = hashOfAll(chance.moment().state);
  auto& slot = visited[hash % kVisited];
  repeated = std::exchange(slot, hash) == hash ? repeated + 1 : 0;
  return repeated > kMostRepeated;
}

Odds RandomRuns::drawOdds() {
  const double wait = std::pow(2 * longestTime, std::uniform_real_distribution()(random));
  if (fruitful.empty() || random() % 2 == 0) {
    Odds made{std::vector<double>(system.transitions.size()), wait};
    for (auto& weight : made.weights) weight = drawWeight();
    return made;
  }
  Odds made = fruitful[random() % fruitful.size()];
  made.wait = wait;
  for (auto& weight : made.weights)
    if (random() % 16 == 0) weight = drawWeight();
  return made;
}

double RandomRuns::drawWeight() {
  static constexpr std::array kWeights{1.0, 1.0, 1.0, 1.0 / 4, 1.0 / 16, 1.0 / 256};
  return kWeights.at(random() % kWeights.size());
}

/// Of several, the one that was used least often without finding anything, and then the newest.
std::size_t RandomRuns::pickDiscovery() {
  const auto any = [&] { return random() % discoveries.size(); };
  std::size_t best = any();
  for (auto more = random() % 8; more > 0; --more)
    if (const auto other = any(); isBetter(other, best)) best = other;
  ++discoveries[best].uses;
  return best;
}

bool RandomRuns::isBetter(std::size_t one, std::size_t other) const {
  const auto uses = [&](std::size_t i) { return discoveries[i].uses; };
  return uses(one) != uses(other) ? uses(one) < uses(other) : one > other;
}

void RandomRuns::keepOdds() {
  if (fruitful.size() < kMostFruitful)
    fruitful.push_back(odds);
  else
    fruitful[random() % kMostFruitful] = odds;
}

} // namespace proskill::verify
