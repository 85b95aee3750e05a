#include "verify/trace/replay.h"

#include "verify/state/evaluate.h"
#include "verify/trace/monitor_stays.h"
#include "verify/trace/simulator.h"

#include <algorithm>

namespace proskill::verify {

namespace {

Bits setOf(const std::vector<EventId>& all) {
  Bits events;
  for (auto event : all) events.insert(event);
  return events;
}

/// Whether the end of a run with this many steps shows what the goal asks for.
bool shows(const System& system, const Goal& goal, const ReplayedRun& run, std::size_t steps) {
  if (steps == 0 && goal.initially) return true;
  const Concrete& after = run.after(steps);
  const Concrete& before = run.after(steps == 0 ? 0 : steps - 1);
  const Bits events = steps == 0 ? Bits{} : setOf(run.events(steps - 1));
  if (goal.kind == GoalKind::Events) return events.meets(goal.events);
  const Moment step{before.state.data(), after.state.data(), &events};
  const Moment still{after.state.data(), nullptr, nullptr};
  return holdsAt(system, goal.condition, still) || holdsAt(system, goal.condition, step);
}

/// Whether the monitor can make the moves of the evidence on the replayed run.
class Following {
public:
  /// \param end whether no step is possible after the last one
  Following(const System& of, const Evidence& from, const Dating& at, bool end)
      : system(of), evidence(from), monitor(*from.monitor), dating(at), ended(end) {}

  [[nodiscard]] std::string follow(const ReplayedRun& run) {
    std::size_t own = 0;
    std::int64_t reset = 0;
    std::optional<std::int64_t> tick;
    std::uint32_t location = monitor.initial.at(0);
    if (!evidence.marks.empty()) location = evidence.marks[0].location;
    visited.push_back({0, location});
    for (const MonitorMove& mark : evidence.marks) {
      const auto& at = monitor.locations[mark.location];
      if (mark.location != location) return "the monitor is elsewhere";
      const std::int64_t date =
          mark.atStep ? dating.steps[mark.after - 1].date : dating.marks[own++];
      if (mark.ticks) {
        if (tick && date - *tick < dating.scale) return "time does not go on";
        tick = date;
        visited.push_back({mark.after, location});
        continue;
      }
      const auto& edge = at.edges[mark.edge];
      if (at.timed && !fits(edge.clock, date - reset)) return "the monitor's clock says no";
      if (!isSeen(mark, edge.condition, run)) return "the monitor does not see it";
      if (edge.reset) reset = date;
      location = edge.to;
      visited.push_back({mark.after, location});
    }
    if (!staysWhereItMay(run)) return "the monitor stays where it may not";
    if (monitor.locations[location].error) return {};
    if (evidence.loop) return goesRound(location) ? "" : "the repeated steps are not a violation";
    if (!ended) return "something is still possible at the end";
    return staysBad(location) ? "" : "the end is not a violation";
  }

private:
  struct Visit {
    std::size_t after; ///< number of steps
    std::uint32_t location;
  };

  /// Whether time passes only in states that the monitor's location allows.
  [[nodiscard]] bool staysWhereItMay(const ReplayedRun& run) const {
    MonitorStays stays(evidence);
    bool may = true;
    for (std::size_t i = 0; i <= evidence.steps.size(); ++i)
      stays.eachIn(i, [&](const MonitorStay& stay) {
        const Word* state = run.after(i).state.data();
        may = may &&
              (dateOf(stay.to) <= dateOf(stay.from) ||
               holdsAt(system, monitor.locations[stay.location].stay, {state, nullptr, nullptr}));
      });
    return may;
  }

  /// By the numbers of dates.h.
  [[nodiscard]] std::int64_t dateOf(std::size_t number) const {
    const std::size_t last = evidence.steps.size();
    if (number == 0) return 0;
    if (number <= last) return dating.steps[number - 1].date;
    return number == last + 1 ? dating.end : dating.marks[number - last - 2];
  }

  /// Whether the monitor visits an accepting location between the beginning and the end of the
  /// loop, where it is in the same location.
  [[nodiscard]] bool goesRound(std::uint32_t last) const {
    bool accepts = false;
    for (std::size_t i = visited.size(); i-- > 0;) {
      accepts = accepts || monitor.locations[visited[i].location].accepting;
      const auto until = i + 1 < visited.size() ? visited[i + 1].after : evidence.steps.size();
      const bool isThere = visited[i].after <= *evidence.loop && *evidence.loop <= until;
      if (isThere && accepts && visited[i].location == last) return true;
    }
    return false;
  }

  /// Whether the monitor, continuing alone, visits an accepting location infinitely often.
  [[nodiscard]] bool staysBad(std::uint32_t last) const {
    if (!evidence.rest || visited[*evidence.rest].location != last) return false;
    const auto from = static_cast<std::ptrdiff_t>(*evidence.rest);
    const bool goesOn =
        std::any_of(evidence.marks.begin() + from, evidence.marks.end(),
                    [](const MonitorMove& mark) { return mark.atEnd || mark.ticks; });
    return goesOn && std::any_of(visited.begin() + from, visited.end(), [&](const Visit& visit) {
             return monitor.locations[visit.location].accepting;
           });
  }

  [[nodiscard]] bool fits(const ClockGuard& guard, std::int64_t age) const {
    const auto within = [&](std::int64_t value, Bound limit) {
      const std::int64_t most = constantOf(limit) * dating.scale;
      return limit == kInfinite || value < most || (value == most && limit % 2 != 0);
    };
    return within(-age, guard.lower) && within(age, guard.upper);
  }

  [[nodiscard]] bool isSeen(const MonitorMove& mark, NodeId condition,
                            const ReplayedRun& run) const {
    if (!mark.atStep) {
      for (std::size_t i = mark.after; i <= mark.until; ++i)
        if (!holdsAt(system, condition, {run.after(i).state.data(), nullptr, nullptr}))
          return false;
      return true;
    }
    const Bits all = setOf(run.events(mark.after - 1));
    const Word* here = run.after(mark.after).state.data();
    return holdsAt(system, condition, {run.after(mark.after - 1).state.data(), here, &all});
  }

  const System& system;
  const Evidence& evidence;
  const Monitor& monitor;
  const Dating& dating;
  bool ended;
  std::vector<Visit> visited; ///< locations of the monitor, in order
};

/// Whether the end of the run shows what the goal asks for, after this many steps.
std::string judge(const System& system, const Goal& goal, const Evidence& evidence,
                  const Dating& dating, const Simulator& simulator, const ReplayedRun& run) {
  const std::size_t count = evidence.steps.size();
  const Concrete& now = run.after(count);
  switch (goal.kind) {
  case GoalKind::Deadlock:
    if (!now.since.empty()) return "something is still possible at the end";
    return holdsAt(system, goal.condition, {now.state.data()}) ? "the end is one that is allowed"
                                                               : "";
  case GoalKind::Stuck:
    return simulator.canGoOn(now, dating.end) ? "time can still go on at the end" : "";
  case GoalKind::Run:
    if (!evidence.monitor) return "it is not known what of the run shows the violation";
    return Following(system, evidence, dating,
                     now.since.empty() || (evidence.monitor->letsRest() && simulator.mayRest(now)))
        .follow(run);
  case GoalKind::Error: return "nothing fails";
  case GoalKind::Lost:
    return holdsAt(system, goal.condition, {now.state.data()}) ? "the condition is true at the end"
                                                               : "";
  case GoalKind::Events:
  case GoalKind::Condition:
  case GoalKind::Longest:
  case GoalKind::Shortest:
  case GoalKind::Unsupported: break;
  }
  return shows(system, goal, run, count) ? "" : "the end does not show what was asked for";
}

} // namespace

const Simulator& ReplayedRun::start(std::int64_t units) {
  if (simulator && scale == units) return *simulator;
  taken.clear();
  scale = units;
  if (!simulator) {
    simulator.emplace(system, units);
    first = simulator->start();
  }
  simulator->setUnits(units);
  return *simulator;
}

std::string ReplayedRun::take(std::size_t before, TransitionId step, std::int64_t date) {
  if (before < taken.size() && taken[before].step == step && taken[before].date == date) return {};
  limits.check();
  taken.resize(before);
  const Concrete& now = after(before);
  const std::int64_t last = before == 0 ? 0 : taken[before - 1].date;
  if (date < last || !simulator->mayWait(now, date)) return "comes too late";
  if (!simulator->isRipe(now, step, date)) return "comes too early";
  StepLog log;
  auto next = simulator->take(now, step, date, log);
  if (!next) return "is not possible";
  limits.checkGrowth(taken, 1);
  taken.push_back({step, date, std::move(*next), std::move(log.events)});
  return {};
}

Rest ReplayedRun::restAfter(std::size_t steps) const {
  if (steps > taken.size()) return Rest::No; // too long to be stored
  const Concrete& now = after(steps);
  const bool isStill = std::ranges::all_of(now.since, [&](const auto& enabled) {
    StepLog log;
    const auto next = simulator->take(now, enabled.first, enabled.second, log);
    return next && next->state == now.state;
  });
  if (isStill) return Rest::Forced;
  return simulator->mayRest(now) ? Rest::Allowed : Rest::No;
}

void ReplayedRun::forgetLong() {
  constexpr std::size_t kMostKept = 4096;
  if (taken.size() > kMostKept) taken.resize(kMostKept);
}

std::string replay(const System& system, const Goal& goal, const Evidence& evidence,
                   const Dating& dating, ReplayedRun& run) {
  const Steps& steps = evidence.steps;
  const Simulator& simulator = run.start(dating.scale);
  const std::size_t last = steps.size() - (goal.kind == GoalKind::Error && !steps.empty() ? 1 : 0);
  for (std::size_t i = 0; i < last; ++i)
    if (auto wrong = run.take(i, steps[i], dating.steps[i].date); !wrong.empty())
      return "step " + std::to_string(i + 1) + " " + wrong;
  const Concrete& now = run.after(last);
  const std::int64_t before = last == 0 ? 0 : dating.steps[last - 1].date;
  const std::int64_t end = last < steps.size() ? dating.steps[last].date : dating.end;
  if (end < before || !simulator.mayWait(now, end)) return "the end comes too late";
  std::string wrong;
  if (last < steps.size()) {
    StepLog log;
    if (!simulator.isRipe(now, steps[last], end))
      wrong = "the error comes too early";
    else if (!simulator.fails(now, steps[last], log))
      wrong = "the last step does not fail";
  } else {
    wrong = judge(system, goal, evidence, dating, simulator, run);
  }
  run.forgetLong();
  return wrong;
}

} // namespace proskill::verify
