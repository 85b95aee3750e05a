#include "verify/measure/duration_search.h"

#include "verify/monitor/duration_monitor.h"
#include "verify/reduce/monitor_view.h"

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr std::int32_t kFactor = 4;
constexpr std::int32_t kMost = INT32_MAX / 16; ///< greatest constant of a measurement

std::int32_t greatestConstant(const System& system) {
  std::int64_t most = 1;
  for (const auto& transition : system.transitions)
    most = std::max({most, transition.interval.lower, transition.interval.upper.value_or(0)});
  return static_cast<std::int32_t>(std::min<std::int64_t>(most, kMost));
}

class Search {
public:
  Search(const System& of, const Goal& asked, const Suits& with, bool errors, bool shows,
         LimitWatch& watch)
      : system(of),
        goal(asked),
        suits(with),
        errorsAreAsked(errors),
        showsTimes(shows),
        limits(watch) {
    found.statistics.complete = true;
  }

  DurationSearch run() {
    MeasuredClock clock{.longest = goal.kind == GoalKind::Longest};
    for (clock.most = greatestConstant(system);; clock.most *= kFactor) {
      clock.found.reset();
      if (!explore(goal.monitor, &clock)) return std::move(found);
      if (!clock.isBeyond()) break;
      if (clock.longest && showEndless()) return std::move(found);
      if (!found.unknown.empty() || found.failure) return std::move(found);
      if (clock.most > kMost / kFactor) return giveUp("the time is too long to be measured");
    }
    if (!clock.found)
      found.duration = Duration{};
    else if (clock.longest)
      show({constantOf(*clock.found), *clock.found % 2 == 0});
    else
      show({-constantOf(*clock.found), *clock.found % 2 == 0});
    return std::move(found);
  }

private:
  DurationSearch giveUp(std::string why) {
    found.unknown = std::move(why);
    return std::move(found);
  }

  /// \return whether everything was explored, or evidence was found
  bool explore(const Monitor& monitor, MeasuredClock* clock) {
    auto run = std::make_unique<DurationRun>();
    run->goal = {.kind = GoalKind::Run, .monitor = monitor};
    run->prepared.emplace(
        system, goalsOf(monitor), [&](Reduction each) { return suits(run->goal.monitor, each); },
        limits);
    auto watched = watchFor(run->prepared->system, run->goal.monitor, run->prepared->reductions, {},
                            errorsAreAsked, limits, clock);
    if (watched.evidence) watched.statistics.complete = true;
    add(found.statistics, watched.statistics);
    if (!watched.failure.empty()) {
      found.failure = Unsupported{watched.failure, watched.failureOrigin};
      return false;
    }
    if (!watched.statistics.complete) {
      found.unknown = watched.statistics.stopped;
      return false;
    }
    if (!watched.evidence) return true;
    run->evidence = std::move(*watched.evidence);
    found.run = std::move(run);
    return true;
  }

  bool showEndless() {
    if (isFinite) return false;
    const Duration endless{.happens = true, .bounded = false};
    if (!explore(goalShowing(goal, endless)->monitor, nullptr)) return false;
    isFinite = !found.run;
    if (found.run) found.duration = endless;
    return found.run != nullptr;
  }

  void show(Date value) {
    const Duration duration{.happens = true, .value = value};
    if (showsTimes && !explore(goalShowing(goal, duration)->monitor, nullptr)) return;
    if (showsTimes && !found.run)
      found.unknown = "internal error, please report it: no run takes this time";
    else
      found.duration = duration;
  }

  const System& system;
  const Goal& goal;
  const Suits& suits;
  bool errorsAreAsked;
  bool showsTimes;
  LimitWatch& limits;
  bool isFinite = false;
  DurationSearch found;
};

/// The monitor of runs that take this time, or one that is less than a unit from it if the time
/// itself is excluded.
Monitor taking(const Goal& goal, const Duration& duration) {
  const auto [value, strict] = std::pair(duration.value.value, duration.value.strict);
  const auto at = static_cast<std::int32_t>(value);
  if (!duration.bounded) return endless(goal.monitor);
  if (goal.kind == GoalKind::Shortest)
    return ending(goal.monitor, {.upper = strict ? bound(at + 1, true) : bound(at, false)});
  const auto least = strict ? bound(1 - at, true) : bound(-at, false);
  return lasting(goal.monitor, {.lower = std::min(least, kZero)});
}

} // namespace

std::optional<Goal> goalShowing(const Goal& goal, const Duration& duration) {
  if (!duration.happens) return std::nullopt;
  return Goal{.kind = GoalKind::Run, .monitor = taking(goal, duration)};
}

DurationSearch searchDuration(const System& whole, const Goal& goal, const Suits& suits,
                              bool errorsAreAsked, bool showsTimes, LimitWatch& limits) {
  return Search(whole, goal, suits, errorsAreAsked, showsTimes, limits).run();
}

} // namespace proskill::verify
