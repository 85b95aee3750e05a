#include "verify/sample/chance_run.h"

#include "verify/state/state_layout.h"

#include <algorithm>
#include <tuple>

namespace proskill::verify {

namespace {

constexpr std::size_t kNever = SIZE_MAX;

std::size_t ticks(std::int64_t units) {
  return static_cast<std::size_t>(units) * ChanceRun::kTicks;
}

/// Whether an event of this probability happens.
bool happens(double probability, ChanceRun::Random& random) {
  return std::bernoulli_distribution(probability)(random);
}

} // namespace

ChanceRun::ChanceRun(const System& of, const Enabling& with)
    : system(of), enabling(with), at(start()) {}

RunMoment ChanceRun::start() const {
  RunMoment made{initialState(system), {}, ClockStarts(system)};
  enabling.compute(made.state.data(), made.enabled);
  return made;
}

/// The date until which the next step has to happen.
std::size_t ChanceRun::latest() const {
  if (enabling.isUrgent(at.enabled)) return at.now;
  std::size_t last = kNever;
  eachIn(at.enabled, [&](TransitionId id) {
    const auto& [clock, interval] =
        std::tie(system.transitions[id].clock, system.transitions[id].interval);
    if (clock == kNone || !interval.upper) return;
    last =
        std::min(last, at.since.of(clock) + ticks(*interval.upper) - (interval.upperOpen ? 1 : 0));
  });
  return last;
}

std::size_t ChanceRun::earliest(const Transition& transition) const {
  if (transition.clock == kNone) return at.now;
  const auto& interval = transition.interval;
  return std::max(at.now, at.since.of(transition.clock) + ticks(interval.lower) +
                              (interval.lowerOpen ? 1 : 0));
}

/// Steps with a clock take part by their weight; the others always do, but wait for longer.
void ChanceRun::drawDates(const Odds& odds, Random& random) {
  candidates.clear();
  const std::size_t last = latest();
  eachIn(at.enabled, [&](TransitionId id) {
    const auto& transition = system.transitions[id];
    const std::size_t from = earliest(transition);
    if (from > last) return;
    const double weight = odds.weights[id];
    candidates.push_back({id, drawDate(transition, weight, from, last, odds, random), weight});
  });
}

std::size_t ChanceRun::drawDate(const Transition& transition, double weight, std::size_t first,
                                std::size_t last, const Odds& odds, Random& random) const {
  if (first == last || transition.urgent) return first;
  if (transition.clock == kNone) {
    const double wait = std::exponential_distribution(weight / odds.wait)(random);
    return wait < static_cast<double>(last - first) ? first + static_cast<std::size_t>(wait) : last;
  }
  // without an upper bound: up to as long again as it must wait
  if (!transition.interval.upper) last = std::min(last, first + ticks(transition.interval.lower));
  const unsigned kind = random() % 4; // the bounds themselves show most
  if (kind == 0) return first;
  if (kind == 1) return last;
  return std::uniform_int_distribution(first, last)(random);
}

/// The index of the step that happens first. Of several at one date, the weights decide.
std::size_t ChanceRun::first(Random& random) const {
  std::size_t best = candidates.size();
  double together = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto& [step, date, weight] = candidates[i];
    if (system.transitions[step].clock != kNone && !happens(weight, random)) continue;
    if (best < candidates.size() && date > candidates[best].date) continue;
    if (best == candidates.size() || date < candidates[best].date) together = 0;
    together += weight;
    if (happens(weight / together, random)) best = i;
  }
  return best < candidates.size() ? best : random() % candidates.size();
}

std::optional<TransitionId> ChanceRun::step(const Odds& odds, Random& random) {
  failure.reset();
  drawDates(odds, random);
  while (!candidates.empty() && !failure) {
    const std::size_t next = first(random);
    const Candidate chosen = candidates[next];
    if (take(chosen)) return chosen.step;
    candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(next));
  }
  return std::nullopt;
}

bool ChanceRun::takeEarly(TransitionId step) {
  if (!contains(at.enabled, step)) return false;
  const std::size_t date = earliest(system.transitions[step]);
  return date <= latest() && take({step, date, 1});
}

bool ChanceRun::take(const Candidate& candidate) {
  previous = at.state;
  log.clear();
  const Outcome outcome = fire(system, candidate.step, at.state.data(), log);
  if (outcome == Outcome::Failed) failure = candidate.step;
  if (outcome != Outcome::Done) {
    at.state = previous;
    return false;
  }
  at.now = candidate.date;
  enabledBefore = at.enabled;
  enabling.update(candidate.step, at.state.data(), at.enabled);
  at.since.restart(candidate.step, enabledBefore, at.enabled, at.now);
  return true;
}

} // namespace proskill::verify
