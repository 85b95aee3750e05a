#include "verify/trace/replay.h"

#include "verify/state/evaluate.h"
#include "verify/trace/simulator.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

namespace {

bool shows(const System& system, const Goal& goal, const Concrete& before, const Concrete& after,
           const StepLog& log) {
  Bits events;
  for (auto event : log.events) events.insert(event);
  if (goal.kind == GoalKind::Events) return events.meets(goal.events);
  const Moment step{before.state.data(), after.state.data(), &events};
  const Moment still{after.state.data(), nullptr, nullptr};
  return holdsAt(system, goal.condition, still) || holdsAt(system, goal.condition, step);
}

/// Whether the monitor can make the moves of the evidence on the run as it was played.
class Following {
public:
  /// \param end whether nothing is possible behind the last step
  Following(const System& of, const Evidence& from, const Dating& at, bool end)
      : system(of), evidence(from), monitor(*from.monitor), dating(at), ended(end) {}

  [[nodiscard]] std::string run(const std::vector<Concrete>& states,
                                const std::vector<std::vector<EventId>>& events) {
    std::size_t own = 0;
    std::int64_t reset = 0;
    std::uint32_t location = monitor.initial.at(0);
    if (!evidence.marks.empty()) location = evidence.marks[0].location;
    visited.push_back({0, location});
    for (const MonitorMove& mark : evidence.marks) {
      const auto& at = monitor.locations[mark.location];
      const auto& edge = at.edges[mark.edge];
      if (mark.location != location) return "the monitor is elsewhere";
      const std::int64_t date =
          mark.atStep ? dating.steps[mark.after - 1].date : dating.marks[own++];
      if (at.timed && !fits(edge.clock, date - reset)) return "the monitor's clock says no";
      if (!isSeen(mark, edge.condition, states, events)) return "the monitor does not see it";
      if (edge.reset) reset = date;
      location = edge.to;
      visited.push_back({mark.after, location});
    }
    if (monitor.locations[location].error) return {};
    if (evidence.loop) return goesRound(location) ? "" : "what is repeated is no violation";
    if (!ended) return "something is still possible at the end";
    return staysBad(location) ? "" : "the end is no violation";
  }

private:
  struct Visit {
    std::size_t after; ///< steps
    std::uint32_t location;
  };

  /// Whether the monitor comes by an accepting location, from where it is at the loop's beginning
  /// to where it is at its end, which is the same.
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

  /// Whether the monitor, which alone goes on, comes by an accepting location again and again.
  [[nodiscard]] bool staysBad(std::uint32_t last) const {
    if (!evidence.rest || visited[*evidence.rest].location != last) return false;
    const auto from = static_cast<std::ptrdiff_t>(*evidence.rest);
    const bool goesOn = std::any_of(evidence.marks.begin() + from, evidence.marks.end(),
                                    [](const MonitorMove& mark) { return mark.atEnd; });
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
                            const std::vector<Concrete>& states,
                            const std::vector<std::vector<EventId>>& events) const {
    if (!mark.atStep) {
      for (std::size_t i = mark.after; i <= mark.until; ++i)
        if (!holdsAt(system, condition, {states[i].state.data(), nullptr, nullptr})) return false;
      return true;
    }
    Bits all;
    for (auto event : events[mark.after - 1]) all.insert(event);
    const Word* here = states[mark.after].state.data();
    return holdsAt(system, condition, {states[mark.after - 1].state.data(), here, &all});
  }

  const System& system;
  const Evidence& evidence;
  const Monitor& monitor;
  const Dating& dating;
  bool ended;
  std::vector<Visit> visited; ///< where the monitor was, in order
};

} // namespace

std::string replay(const System& system, const Goal& goal, const Evidence& evidence,
                   const Dating& dating) {
  const Steps& steps = evidence.steps;
  Simulator simulator(system, dating.scale);
  Concrete now = simulator.start();
  Concrete before = now;
  StepLog log;
  std::vector<Concrete> states{now};
  std::vector<std::vector<EventId>> events;
  std::int64_t last = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::int64_t date = dating.steps[i].date;
    const std::string where = "step " + std::to_string(i + 1) + " ";
    if (date < last || !simulator.mayWait(now, date)) return where + "comes too late";
    if (!simulator.isRipe(now, steps[i], date)) return where + "comes too early";
    if (goal.kind == GoalKind::Error && i + 1 == steps.size())
      return simulator.fails(now, steps[i], log) ? "" : where + "does not fail";
    auto next = simulator.take(now, steps[i], date, log);
    if (!next) return where + "is not possible";
    before = std::exchange(now, std::move(*next));
    last = date;
    if (!evidence.monitor) continue;
    states.push_back(now);
    events.push_back(log.events);
  }
  if (dating.end < last || !simulator.mayWait(now, dating.end)) return "the end comes too late";
  switch (goal.kind) {
  case GoalKind::Deadlock:
    if (!now.since.empty()) return "something is still possible at the end";
    return holdsAt(system, goal.condition, {now.state.data()}) ? "the end is one that is allowed"
                                                               : "";
  case GoalKind::Stuck:
    return simulator.canGoOn(now, dating.end) ? "time can still go on at the end" : "";
  case GoalKind::Run:
    if (!evidence.monitor) return "it is not known what of the run shows the violation";
    return Following(system, evidence, dating, now.since.empty()).run(states, events);
  case GoalKind::Error: return "nothing fails";
  case GoalKind::Events:
  case GoalKind::Condition:
  case GoalKind::Unsupported: break;
  }
  if (steps.empty() && goal.initially) return {};
  return shows(system, goal, before, now, log) ? "" : "the end does not show what was asked for";
}

} // namespace proskill::verify
