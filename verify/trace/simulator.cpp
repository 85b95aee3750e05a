#include "verify/trace/simulator.h"

#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <algorithm>
#include <set>

namespace proskill::verify {

Simulator::Simulator(const System& of, std::int64_t units)
    : system(of), scale(units), readers(of.cells.size()) {
  for (const auto& instance : system.instances) takingPart.emplace_back(instance.locations.size());
  for (TransitionId id = 0; id < system.transitions.size(); ++id) {
    const Transition& transition = system.transitions[id];
    Bits read = transition.guardReads;
    for (auto part : transition.parts) {
      const Path& path = system.paths[part];
      takingPart[path.instance][path.location].push_back(id);
      read.erase(system.instances[path.instance].location);
    }
    read.each([&](CellId cell) { readers[cell].push_back(id); });
  }
}

Concrete Simulator::start() const {
  Concrete made{initialState(system), {}};
  for (TransitionId id = 0; id < system.transitions.size(); ++id)
    if (isEnabled(system, id, made.state.data())) made.since.add(id, 0);
  return made;
}

bool Simulator::mayWait(const Concrete& now, std::int64_t date) const {
  return std::ranges::all_of(now.since, [&](const auto& entry) {
    const auto& interval = system.transitions[entry.first].interval;
    const std::int64_t age = date - entry.second;
    const std::int64_t most = interval.upper.value_or(0) * scale;
    return !interval.upper || age < most || (age == most && !interval.upperOpen);
  });
}

bool Simulator::mayRest(const Concrete& now) const {
  return std::ranges::none_of(now.since, [&](const auto& entry) {
    return system.transitions[entry.first].interval.upper.has_value();
  });
}

bool Simulator::isRipe(const Concrete& now, TransitionId id, std::int64_t date) const {
  const auto canGo = [&](TransitionId other) { return isOldEnough(now, other, date); };
  const auto& of = system.transitions[id];
  return canGo(id) && std::ranges::none_of(of.blockers, canGo) &&
         std::ranges::none_of(of.laterBlockers, canGo);
}

/// Whether it has been enabled for long enough.
bool Simulator::isOldEnough(const Concrete& now, TransitionId id, std::int64_t date) const {
  auto enabled = now.since.find(id);
  if (enabled == now.since.end()) return false;
  const auto& interval = system.transitions[id].interval;
  const std::int64_t age = date - enabled->second;
  return age > interval.lower * scale || (age == interval.lower * scale && !interval.lowerOpen);
}

std::optional<Opportunity> Simulator::opportunity(const Concrete& now, TransitionId id,
                                                  std::int64_t date) const {
  if (isBlocked(now, id)) return std::nullopt;
  const auto& interval = system.transitions[id].interval;
  Opportunity found{now.since.at(id) + interval.lower * scale, interval.lowerOpen, {}, false};
  if (found.earliest < date) found = {date, false, {}, false};
  const auto limit = [&](std::int64_t latest, bool open) {
    if (found.latest && (*found.latest < latest || (*found.latest == latest && !open))) return;
    found.latest = latest;
    found.beforeLatest = open;
  };
  for (const auto& [other, since] : now.since) {
    const auto& bound = system.transitions[other].interval;
    if (bound.upper) limit(since + *bound.upper * scale, bound.upperOpen);
  }
  for (auto blocker : system.transitions[id].laterBlockers)
    if (auto since = now.since.find(blocker); since != now.since.end()) {
      const auto& bound = system.transitions[blocker].interval;
      limit(since->second + bound.lower * scale, !bound.lowerOpen);
    }
  const bool strict = found.afterEarliest || found.beforeLatest;
  if (found.latest &&
      (*found.latest < found.earliest || (strict && *found.latest == found.earliest)))
    return std::nullopt;
  return found;
}

bool Simulator::fails(const Concrete& now, TransitionId id, StepLog& log) const {
  auto state = now.state;
  log.clear();
  return fire(system, id, state.data(), log) == Outcome::Failed;
}

std::optional<Concrete> Simulator::take(const Concrete& now, TransitionId id, std::int64_t date,
                                        StepLog& log) const {
  Concrete next{now.state, {}};
  log.clear();
  if (fire(system, id, next.state.data(), log) != Outcome::Done) return std::nullopt;
  const auto changed = affected(id, now.state, next.state);
  next.since.reserve(now.since.size() + changed.size());
  auto same = now.since.begin();
  for (auto other : changed) {
    for (; same != now.since.end() && same->first < other; ++same)
      next.since.add(same->first, same->second);
    if (same != now.since.end() && same->first == other) ++same;
    if (!isEnabled(system, other, next.state.data())) continue;
    const auto clocked = withoutObservers(other);
    const auto before = now.since.find(clocked);
    const bool goesOn = before != now.since.end() && clocked != withoutObservers(id) &&
                        !disturbs(system, id, clocked);
    next.since.add(other, goesOn ? before->second : date);
  }
  for (; same != now.since.end(); ++same) next.since.add(same->first, same->second);
  return next;
}

bool Simulator::canGoOn(const Concrete& now, std::int64_t date) const {
  constexpr std::size_t kWidest = 20'000;
  std::set<Concrete> seen{now};
  std::vector<Concrete> todo{now};
  StepLog log;
  while (!todo.empty()) {
    Concrete at = std::move(todo.back());
    todo.pop_back();
    if (mayWaitALittle(at, date)) return true;
    if (seen.size() > kWidest) return false;
    for (const auto& [id, _] : at.since) {
      if (!isAwaited(at, id, date) || !isRipe(at, id, date)) continue;
      auto next = take(at, id, date, log);
      if (next && seen.insert(*next).second) todo.push_back(std::move(*next));
    }
  }
  return false;
}

/// Whether it has to be taken at this date, or has priority over a step that has to.
bool Simulator::isAwaited(const Concrete& now, TransitionId id, std::int64_t date) const {
  const auto waits = [&](TransitionId other) {
    const auto& interval = system.transitions[other].interval;
    return interval.upper && !interval.upperOpen &&
           date - now.since.at(other) >= *interval.upper * scale;
  };
  const auto letsItGoFirst = [&](const auto& entry) {
    const auto has = [&](const auto& all) { return std::ranges::count(all, id) > 0; };
    const auto& of = system.transitions[entry.first];
    return waits(entry.first) && (has(of.blockers) || has(of.laterBlockers));
  };
  return waits(id) || (system.hasPriorities && std::ranges::any_of(now.since, letsItGoFirst));
}

void Simulator::addTakingPart(InstanceId instance, const std::vector<Word>& state,
                              std::vector<TransitionId>& to) const {
  const auto at = readCell(system, system.instances[instance].location, state.data());
  const auto& all = takingPart[instance][static_cast<std::size_t>(at)];
  to.insert(to.end(), all.begin(), all.end());
}

std::vector<TransitionId> Simulator::affected(TransitionId step, const std::vector<Word>& before,
                                              const std::vector<Word>& after) const {
  std::vector<TransitionId> all;
  for (auto part : system.transitions[step].parts) {
    const InstanceId instance = system.paths[part].instance;
    addTakingPart(instance, before, all);
    addTakingPart(instance, after, all);
  }
  system.transitions[step].writes.each(
      [&](CellId cell) { all.insert(all.end(), readers[cell].begin(), readers[cell].end()); });
  std::ranges::sort(all);
  const auto repeated = std::ranges::unique(all);
  all.erase(repeated.begin(), repeated.end());
  return all;
}

/// The same step without observers, which do not affect its time.
TransitionId Simulator::withoutObservers(TransitionId id) const {
  const auto unseen = system.transitions[id].unseen;
  return unseen == kNone ? id : unseen;
}

/// Whether a transition with priority is enabled.
bool Simulator::isBlocked(const Concrete& now, TransitionId id) const {
  return std::ranges::any_of(system.transitions[id].blockers,
                             [&](TransitionId blocker) { return now.since.contains(blocker); });
}

/// Whether some time may pass, however little.
bool Simulator::mayWaitALittle(const Concrete& now, std::int64_t date) const {
  return std::ranges::all_of(now.since, [&](const auto& entry) {
    const auto& interval = system.transitions[entry.first].interval;
    return !interval.upper || date - entry.second < *interval.upper * scale;
  });
}

} // namespace proskill::verify
