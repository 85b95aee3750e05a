#include "verify/explore/progress_check.h"

#include "verify/reduce/live_variables.h"

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr std::size_t kLevelsPerWord = 8;

} // namespace

ProgressCheck::ProgressCheck(const System& of, const Reductions& with, ZoneGraph& explored,
                             LimitWatch& watch)
    : system(of),
      reductions(with),
      graph(explored),
      limits(watch),
      moments(static_cast<std::uint32_t>(of.storedWords + (of.clocks.size() + kLevelsPerWord - 1) /
                                                              kLevelsPerWord)) {}

const std::vector<ProgressCheck::Thresholds>& ProgressCheck::thresholds(SignatureId id) {
  if (id < known.size() && known[id].size() == graph.timing.at(id).clocks.size()) return known[id];
  if (id >= known.size()) known.resize(id + 1);
  const Signature& signature = graph.timing.at(id);
  for (std::size_t i = 0; i < signature.clocks.size(); ++i) {
    auto& made = known[id].emplace_back();
    for (auto transition : signature.enabled) {
      const auto& of = system.transitions[transition];
      const Bound limit = lowerBound(of.interval);
      if (of.clock == signature.clocks[i] && limit != kZero) made.lower.push_back(limit);
    }
    std::ranges::sort(made.lower, std::greater{}); // 0 - x <= -c: the weakest first
    auto twice = std::ranges::unique(made.lower);
    made.lower.erase(twice.begin(), twice.end());
    const Bound upper = signature.invariants[i];
    made.endsAtUpper = upper != kInfinite && upper % 2 != 0; // a strict bound is never reached
    if (made.endsAtUpper) {
      const Bound atUpper = bound(-constantOf(upper), false);
      std::erase_if(made.lower, [&](Bound limit) { return limit <= atUpper; });
      made.lower.push_back(atUpper);
    }
  }
  return known[id];
}

std::optional<StuckMoment> ProgressCheck::find() {
  // In an urgent state it is plain to see that time has stopped; elsewhere it does so at a bound.
  if (auto found = findAmong(true)) return found;
  return findAmong(false);
}

std::optional<StuckMoment> ProgressCheck::findAmong(bool urgent) {
  Moment moment;
  StateId loaded = kNone;
  for (NodeIndex i = 0; i < graph.nodes.size() && !isStopped(); ++i) {
    const ZoneNode& node = graph.nodes[i];
    if (node.covered || graph.timing.at(graph.signatureOf[node.state]).urgent != urgent) continue;
    if (node.state != loaded) {
      moment.state.assign(system.words, 0);
      std::copy_n(graph.states.at(node.state), system.storedWords, moment.state.begin());
      graph.enabling.compute(moment.state.data(), moment.enabled);
      moment.signature = graph.signatureOf[node.state];
      loaded = node.state;
    }
    moment.levels.assign(graph.timing.at(moment.signature).clocks.size(), 0);
    if (split(graph.timing.zones().zone(node.zone), 0, moment))
      return StuckMoment{i, ranges(moment)};
  }
  return std::nullopt;
}

/// Goes through the kinds of moments of a zone, clock by clock. True when a bad one was found; it
/// is then in `moment`.
bool ProgressCheck::split(const Dbm& zone, std::size_t clock, Moment& moment) {
  if (clock == moment.levels.size()) return !letsTimePass(moment) && !isGood(moment);
  const auto at = static_cast<std::uint32_t>(clock + 1);
  const auto limits = thresholds(moment.signature)[clock].lower;
  for (std::size_t level = 0; level <= limits.size(); ++level) {
    Dbm part = zone;
    if (level > 0 && !part.constrain(0, at, limits[level - 1])) return false;
    // Not 0 - x <= -c is x - 0 < c.
    if (level < limits.size() && !part.constrain(at, 0, 1 - limits[level])) continue;
    moment.levels[clock] = static_cast<std::uint8_t>(level);
    if (split(part, clock + 1, moment)) return true;
  }
  return false;
}

/// Looks at the limits now and then.
bool ProgressCheck::isStopped() {
  constexpr std::uint64_t kBetweenChecks = 64;
  if (!stoppedBy.empty() || ++steps % kBetweenChecks != 0) return !stoppedBy.empty();
  const std::uint64_t bytes = graph.bytes() + moments.bytes() +
                              verdicts.capacity() * sizeof(Verdict) +
                              metIn.capacity() * sizeof(std::uint32_t);
  stoppedBy = limits.met({.classes = graph.nodes.size(),
                          .markings = graph.states.size(),
                          .bytes = bytes,
                          .seconds = limits.seconds()});
  return !stoppedBy.empty();
}

bool ProgressCheck::letsTimePass(const Moment& moment) {
  bool fails = false; // the run ends here; that is another question
  eachIn(moment.enabled, [&](TransitionId id) { fails = fails || system.transitions[id].fails; });
  if (fails) return true;
  if (graph.timing.at(moment.signature).urgent) return false;
  const auto& all = thresholds(moment.signature);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].endsAtUpper && moment.levels[i] == all[i].lower.size()) return false;
  return true;
}

bool ProgressCheck::canFire(const Moment& moment, TransitionId transition) {
  const auto& of = system.transitions[transition];
  const Bound limit = lowerBound(of.interval);
  if (of.clock == kNone || limit == kZero) return true;
  const auto& clocks = graph.timing.at(moment.signature).clocks;
  const auto at =
      static_cast<std::size_t>(std::ranges::lower_bound(clocks, of.clock) - clocks.begin());
  const auto& reached = thresholds(moment.signature)[at].lower;
  return moment.levels[at] > 0 && reached[moment.levels[at] - 1U] <= limit;
}

/// Whether something that has priority can fire.
bool ProgressCheck::isBlocked(const Moment& moment, TransitionId transition) {
  const auto canGo = [&](TransitionId id) {
    return contains(moment.enabled, id) && canFire(moment, id);
  };
  const auto& of = system.transitions[transition];
  return std::ranges::any_of(of.blockers, canGo) || std::ranges::any_of(of.laterBlockers, canGo);
}

bool ProgressCheck::fireFrom(const Moment& moment, TransitionId transition, Moment& next) {
  next.state = moment.state;
  next.enabled = moment.enabled;
  log.clear();
  if (fire(system, transition, next.state.data(), log) != Outcome::Done) return false;
  graph.enabling.update(transition, next.state.data(), next.enabled);
  next.signature = graph.enabling.signature(next.enabled, graph.timing);
  const auto& before = graph.timing.at(moment.signature).clocks;
  const auto& after = graph.timing.at(next.signature).clocks;
  next.levels.assign(after.size(), 0);
  for (std::size_t i = 0; i < after.size(); ++i) {
    auto at = std::ranges::lower_bound(before, after[i]);
    bool goesOn = at != before.end() && *at == after[i] && !resets(system, transition, after[i]);
    if (goesOn) next.levels[i] = moment.levels[static_cast<std::size_t>(at - before.begin())];
  }
  if (reductions.liveVariables) reductions.liveVariables->clean(next.state.data());
  return true;
}

StateId ProgressCheck::number(Moment& moment) {
  key.assign(system.storedWords + (system.clocks.size() + kLevelsPerWord - 1) / kLevelsPerWord, 0);
  std::copy_n(moment.state.begin(), system.storedWords, key.begin());
  for (std::size_t i = 0; i < moment.levels.size(); ++i)
    key[system.storedWords + i / kLevelsPerWord] |= Word{moment.levels[i]}
                                                    << (i % kLevelsPerWord * 8);
  auto [id, isNew] = moments.add(key.data());
  if (isNew) verdicts.push_back(Verdict::Unknown);
  if (isNew) metIn.push_back(0);
  return id;
}

void ProgressCheck::load(StateId id, Moment& moment) {
  const Word* stored = moments.at(id);
  moment.state.assign(system.words, 0);
  std::copy_n(stored, system.storedWords, moment.state.begin());
  graph.enabling.compute(moment.state.data(), moment.enabled);
  moment.signature = graph.enabling.signature(moment.enabled, graph.timing);
  moment.levels.resize(graph.timing.at(moment.signature).clocks.size());
  for (std::size_t i = 0; i < moment.levels.size(); ++i)
    moment.levels[i] = static_cast<std::uint8_t>(stored[system.storedWords + i / kLevelsPerWord] >>
                                                 (i % kLevelsPerWord * 8));
}

/// Whether steps without time lead from the moment to one where time passes. Depth first, urgent
/// steps before others, since they are what time waits for. What lies on the way to a good moment
/// is good, and where there is no way all that was seen is bad.
bool ProgressCheck::isGood(const Moment& first) {
  Moment moment = first;
  const StateId start = number(moment);
  if (verdicts[start] != Verdict::Unknown) return verdicts[start] == Verdict::Good;
  struct Seen {
    StateId moment;
    StateId from; ///< the place of the predecessor
  };
  struct Task {
    StateId place;
    bool urgentSteps;
  };
  std::vector<Seen> seen{{start, kNone}};
  std::vector<Task> todo{{0, false}, {0, true}};
  metIn[start] = ++searches;
  Moment next;
  while (!todo.empty()) {
    if (isStopped()) return true; // not known; the search ends
    const auto [place, urgentSteps] = todo.back();
    todo.pop_back();
    load(seen[place].moment, moment);
    bool good = false;
    eachIn(moment.enabled, [&](TransitionId transition) {
      if (good || system.transitions[transition].urgent != urgentSteps) return;
      if (!canFire(moment, transition) || isBlocked(moment, transition)) return;
      if (!fireFrom(moment, transition, next)) return;
      const StateId id = number(next);
      if (letsTimePass(next)) verdicts[id] = Verdict::Good;
      good = verdicts[id] == Verdict::Good;
      if (good || metIn[id] == searches) return;
      metIn[id] = searches;
      const auto added = static_cast<StateId>(seen.size());
      seen.push_back({id, place});
      todo.push_back({added, false});
      todo.push_back({added, true});
    });
    if (!good) continue;
    for (StateId at = place; at != kNone; at = seen[at].from)
      verdicts[seen[at].moment] = Verdict::Good;
    return true;
  }
  for (const auto& one : seen) verdicts[one.moment] = Verdict::Bad;
  return false;
}

std::vector<ClockRange> ProgressCheck::ranges(const Moment& moment) {
  std::vector<ClockRange> all;
  const auto clocks = graph.timing.at(moment.signature).clocks;
  for (std::size_t i = 0; i < clocks.size(); ++i) {
    const auto& limits = thresholds(moment.signature)[i].lower;
    ClockRange range{clocks[i]};
    if (moment.levels[i] > 0) range.lower = limits[moment.levels[i] - 1U];
    if (moment.levels[i] < limits.size()) range.upper = 1 - limits[moment.levels[i]];
    all.push_back(range);
  }
  return all;
}

} // namespace proskill::verify
