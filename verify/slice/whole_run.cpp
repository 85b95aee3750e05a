#include "verify/slice/whole_run.h"

#include "verify/trace/simulator.h"

#include <algorithm>
#include <iterator>

namespace proskill::verify {

namespace {

/// So many steps may a run have beside those of the slice, and so many for each of these.
constexpr std::size_t kAdded = 20'000;
constexpr std::size_t kTimes = 4;

/// Notices that a situation comes again, soon after it does (Brent, 1980).
class CycleDetector {
public:
  /// \param now after a step at `date`
  [[nodiscard]] bool isAgain(const Concrete& now, std::int64_t date) {
    if (date == then && now == seen) return true;
    if (--left > 0) return false;
    seen = now;
    then = date;
    left = period *= 2;
    return false;
  }

private:
  Concrete seen;
  std::int64_t then = -1;
  std::size_t period = 1;
  std::size_t left = 1;
};

class Runner {
public:
  /// \param longest number of steps \param longestPlan if the run is left
  Runner(const System& of, const Bits& notAdded, std::int64_t units, std::size_t longest,
         std::size_t longestPlan, LimitWatch& watch)
      : system(of),
        planned(notAdded),
        scale(units),
        most(longest),
        mostOfPlan(longestPlan),
        limits(watch),
        simulator(of, units),
        now(simulator.start()) {}

  /// Takes the step at its date, after the steps that time or the step itself waits for.
  bool take(TransitionId step, std::int64_t at) {
    CycleDetector cycle;
    while (at != date || !now.since.contains(step)) {
      const auto due = nextDue(at);
      if (!due) break;
      if (planned.contains(due->step)) leave();
      if (!takeAt(due->step, due->date)) return false;
      if (cycle.isAgain(now, date)) return false; // so it never becomes possible
    }
    return takeAt(step, at);
  }

  Steps taken;
  bool hasLeft = false; ///< whether a planned step was taken that is not of the run

private:
  struct Due {
    TransitionId step = 0;
    std::int64_t date = 0;
  };

  void leave() {
    hasLeft = true;
    most = mostOfPlan;
  }

  /// The first step that has to happen before `until`, or at once.
  [[nodiscard]] std::optional<Due> nextDue(std::int64_t until) const {
    std::optional<Due> first;
    for (const auto& [id, since] : now.since) {
      const auto& interval = system.transitions[id].interval;
      if (!interval.upper) continue;
      const auto end = since + *interval.upper * scale;
      const auto last = interval.upperOpen ? end - 1 : end;
      const bool isUrgent = end <= date && system.transitions[id].urgent && !planned.contains(id);
      if (!isUrgent && (interval.upperOpen ? end > until : end >= until)) continue;
      const auto then = std::max(last, date);
      if (!first || then < first->date || (then == first->date && planned.contains(first->step)))
        first = {id, then};
    }
    return first;
  }

  bool takeAt(TransitionId step, std::int64_t at) {
    limits.check();
    if (taken.size() >= most || !simulator.mayWait(now, at) || !simulator.isRipe(now, step, at))
      return false;
    auto next = simulator.take(now, step, at, log);
    if (!next) return false;
    now = std::move(*next);
    date = at;
    taken.push_back(step);
    return true;
  }

  const System& system;
  const Bits& planned;
  std::int64_t scale;
  std::size_t most;
  std::size_t mostOfPlan;
  LimitWatch& limits;
  Simulator simulator;
  Concrete now;
  std::int64_t date = 0;
  StepLog log;
};

} // namespace

WholeRun wholeRun(const System& whole, const Steps& steps, const Bits& planned,
                  const Dating& dating, std::size_t mostOfPlan, LimitWatch& limits) {
  const auto most = std::max(kAdded + kTimes * steps.size(), mostOfPlan);
  Runner runner(whole, planned, dating.scale, most, mostOfPlan, limits);
  std::size_t i = 0;
  while (i < steps.size() && runner.take(steps[i], dating.steps[i].date)) ++i;
  const bool isRun = i == steps.size() && !runner.hasLeft;
  std::copy(steps.begin() + static_cast<std::ptrdiff_t>(i), steps.end(),
            std::back_inserter(runner.taken));
  return {std::move(runner.taken), isRun};
}

} // namespace proskill::verify
