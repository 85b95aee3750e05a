#include "verify/replay.h"

#include "verify/evaluate.h"
#include "verify/place.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace proskill::verify {

namespace {

/// A discrete state, and since when each enabled transition is enabled.
struct Concrete {
  std::vector<Word> state;
  std::map<TransitionId, std::int64_t> since;
  friend auto operator<=>(const Concrete&, const Concrete&) = default;
};

class Simulator {
public:
  Simulator(const System& of, std::int64_t units) : system(of), scale(units) {}

  [[nodiscard]] Concrete start() const {
    Concrete made{initialState(system), {}};
    for (auto id : enabledIn(made.state)) made.since[id] = 0;
    return made;
  }

  /// Whether nothing has to happen before `date`.
  [[nodiscard]] bool mayWait(const Concrete& now, std::int64_t date) const {
    return std::ranges::all_of(now.since, [&](const auto& entry) {
      const auto& interval = system.transitions[entry.first].interval;
      const std::int64_t age = date - entry.second;
      const std::int64_t most = interval.upper.value_or(0) * scale;
      return !interval.upper || age < most || (age == most && !interval.upperOpen);
    });
  }

  [[nodiscard]] bool isRipe(const Concrete& now, TransitionId id, std::int64_t date) const {
    auto enabled = now.since.find(id);
    if (enabled == now.since.end()) return false;
    for (auto blocker : system.transitions[id].blockers)
      if (now.since.contains(blocker)) return false;
    const auto& interval = system.transitions[id].interval;
    const std::int64_t age = date - enabled->second;
    return age > interval.lower * scale || (age == interval.lower * scale && !interval.lowerOpen);
  }

  /// The step itself; what it passes is in `log`.
  [[nodiscard]] std::optional<Concrete> take(const Concrete& now, TransitionId id,
                                             std::int64_t date, StepLog& log) const {
    Concrete next{now.state, {}};
    log.clear();
    if (fire(system, id, next.state.data(), log) != Outcome::Done) return std::nullopt;
    for (auto other : enabledIn(next.state)) {
      auto before = now.since.find(other);
      bool goesOn = before != now.since.end() && other != id && !disturbs(id, other);
      next.since[other] = goesOn ? before->second : date;
    }
    return next;
  }

  /// Whether time can pass now, or after steps that take none. Gives up, with true, in a search
  /// that is too wide.
  [[nodiscard]] bool canGoOn(const Concrete& now, std::int64_t date) const {
    constexpr std::size_t kWidest = 20'000;
    std::set<Concrete> seen{now};
    std::vector<Concrete> todo{now};
    StepLog log;
    while (!todo.empty()) {
      Concrete at = std::move(todo.back());
      todo.pop_back();
      if (mayWaitALittle(at, date) || seen.size() > kWidest) return true;
      for (const auto& [id, _] : at.since) {
        if (!isRipe(at, id, date)) continue;
        auto next = take(at, id, date, log);
        if (next && seen.insert(*next).second) todo.push_back(std::move(*next));
      }
    }
    return false;
  }

private:
  [[nodiscard]] std::vector<TransitionId> enabledIn(const std::vector<Word>& state) const {
    std::vector<TransitionId> all;
    for (TransitionId id = 0; id < system.transitions.size(); ++id)
      if (isEnabled(system, id, state.data())) all.push_back(id);
    return all;
  }

  /// Whether `fired` consumes the place of an instance that takes part in `other`.
  [[nodiscard]] bool disturbs(TransitionId fired, TransitionId other) const {
    return std::ranges::any_of(system.transitions[other].parts, [&](PathId part) {
      return system.transitions[fired].consumed.contains(system.paths[part].instance);
    });
  }

  [[nodiscard]] bool mayWaitALittle(const Concrete& now, std::int64_t date) const {
    return std::ranges::all_of(now.since, [&](const auto& entry) {
      const auto& interval = system.transitions[entry.first].interval;
      return !interval.upper || date - entry.second < *interval.upper * scale;
    });
  }

  const System& system;
  std::int64_t scale;
};

bool shows(const System& system, const Goal& goal, const Concrete& before, const Concrete& after,
           const StepLog& log) {
  Bits events;
  for (auto event : log.events) events.insert(event);
  if (goal.kind == GoalKind::Events) return events.meets(goal.events);
  const Moment step{before.state.data(), after.state.data(), &events};
  const Moment still{after.state.data(), nullptr, nullptr};
  return holdsAt(system, goal.condition, still) || holdsAt(system, goal.condition, step);
}

} // namespace

std::string replay(const System& system, const Goal& goal, const std::vector<TransitionId>& steps,
                   const Dating& dating) {
  Simulator simulator(system, dating.scale);
  Concrete now = simulator.start();
  Concrete before = now;
  StepLog log;
  std::int64_t last = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::int64_t date = dating.steps[i].date;
    const std::string where = "step " + std::to_string(i + 1) + " ";
    if (date < last || !simulator.mayWait(now, date)) return where + "comes too late";
    if (!simulator.isRipe(now, steps[i], date)) return where + "comes too early";
    auto next = simulator.take(now, steps[i], date, log);
    if (!next) return where + "is not possible";
    before = std::exchange(now, std::move(*next));
    last = date;
  }
  if (dating.end < last || !simulator.mayWait(now, dating.end)) return "the end comes too late";
  switch (goal.kind) {
  case GoalKind::Deadlock:
    if (!now.since.empty()) return "something is still possible at the end";
    return holdsAt(system, goal.condition, {now.state.data()}) ? "the end is one that is allowed"
                                                               : "";
  case GoalKind::Stuck:
    return simulator.canGoOn(now, dating.end) ? "time can still go on at the end" : "";
  default: break;
  }
  if (steps.empty() && goal.initially) return {};
  return shows(system, goal, before, now, log) ? "" : "the end does not show what was asked for";
}

} // namespace proskill::verify
