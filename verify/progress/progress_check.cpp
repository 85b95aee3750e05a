#include "verify/progress/progress_check.h"

#include "verify/model/release.h"
#include "verify/reduce/free_inputs.h"
#include "verify/reduce/live_variables.h"
#include "verify/reduce/recurrent_steps.h"

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr std::size_t kLevelsPerWord = 8;

std::size_t wordsOfLevels(const System& system) {
  return (system.clocks.size() + kLevelsPerWord - 1) / kLevelsPerWord;
}

} // namespace

ProgressCheck::ProgressCheck(const System& of, const Reductions& with, ExploredNodes& explored,
                             LimitWatch& watch, std::uint64_t bytes)
    : system(of),
      reductions(with),
      graph(explored),
      limits(watch),
      mostBytes(bytes),
      recurrent(recurrentSteps(of, with.dropped, watch)),
      levelsFrom(with.freeInputs ? of.storedWords * 2 : of.storedWords),
      moments(static_cast<std::uint32_t>(levelsFrom + wordsOfLevels(of))) {}

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
  if (isEmpty(recurrent)) return std::nullopt;
  // in an urgent state time has certainly stopped; elsewhere it may stop at a bound
  if (auto found = findAmong(true)) return found;
  return findAmong(false);
}

std::optional<StuckMoment> ProgressCheck::findAmong(bool urgent) {
  Moment moment;
  constexpr std::uint64_t kNothing = UINT64_MAX;
  std::uint64_t loaded = kNothing;
  for (graph.rewind(); !isStopped() && graph.next();) {
    if (rememberedBytes() > mostBytes) {
      forget();
      loaded = kNothing;
    }
    if (graph.timing.at(graph.signature()).urgent != urgent) continue;
    if (loaded != graph.state()) loadNode(moment);
    loaded = graph.state();
    moment.levels.assign(graph.timing.at(moment.signature).clocks.size(), 0);
    if (split(graph.zone(), 0, moment))
      return StuckMoment{graph.node(), ranges(moment), moment.state};
  }
  return std::nullopt;
}

void ProgressCheck::loadNode(Moment& moment) {
  moment.state.assign(system.words, 0);
  graph.readState(moment.state.data());
  if (reductions.freeInputs)
    moment.unknown = reductions.freeInputs->chosenBits(moment.state.data());
  graph.enabling.compute(moment.state.data(), moment.enabled);
  moment.signature = graph.signature();
}

/// Enumerates the kinds of moments of a zone, clock by clock. \return true if a bad one was found,
/// which is then in `moment`
bool ProgressCheck::split(const Dbm& zone, std::size_t clock, Moment& moment) {
  if (clock == moment.levels.size()) return hasStuckChoice(moment);
  const auto at = static_cast<std::uint32_t>(clock + 1);
  const auto& lower = thresholds(moment.signature)[clock].lower;
  for (std::size_t level = 0; level <= lower.size(); ++level) {
    Dbm part = zone;
    if (level > 0 && !part.constrain(0, at, lower[level - 1])) return false;
    // Not 0 - x <= -c is x - 0 < c.
    if (level < lower.size() && !part.constrain(at, 0, 1 - lower[level])) continue;
    moment.levels[clock] = static_cast<std::uint8_t>(level);
    if (split(part, clock + 1, moment)) return true;
  }
  return false;
}

/// Looks at the limits now and then.
bool ProgressCheck::isStopped() {
  constexpr std::uint64_t kBetweenChecks = 64;
  if (!stoppedBy.empty() || ++steps % kBetweenChecks != 0) return !stoppedBy.empty();
  Progress progress = graph.progress();
  progress.bytes += rememberedBytes();
  progress.seconds = limits.seconds();
  stoppedBy = limits.met(progress, graph.growth() + moments.growth() + growthOf(verdicts) +
                                       growthOf(metIn) + growthOf(openAt));
  return !stoppedBy.empty();
}

std::uint64_t ProgressCheck::rememberedBytes() const {
  return moments.bytes() + verdicts.capacity() * sizeof(Verdict) +
         (metIn.capacity() + openAt.capacity()) * sizeof(std::uint32_t) +
         2 * graph.timing.signatureBytes(); // thresholds are about as large
}

/// What is known about moments and signatures only saves repetitions. Call this between two
/// searches.
void ProgressCheck::forget() {
  release(known);
  graph.forget();
  moments = StateStore(static_cast<std::uint32_t>(levelsFrom + wordsOfLevels(system)));
  release(verdicts);
  release(metIn);
  release(openAt);
}

/// Whether time has stopped for some values of the free inputs; sets these values in `moment`.
bool ProgressCheck::hasStuckChoice(Moment& moment) {
  const Found found = search(moment);
  if (found.verdict != Verdict::Open) return found.verdict == Verdict::Bad;
  const auto& input = reductions.freeInputs->all()[found.open];
  const Cell& cell = system.cells[input.cell];
  for (std::uint32_t value = 0; value < input.values.size(); ++value) {
    Moment part = moment;
    reductions.freeInputs->set(found.open, value, part.state.data());
    part.unknown[cell.word] &= ~cell.mask;
    graph.enabling.compute(part.state.data(), part.enabled);
    if (!hasStuckChoice(part)) continue;
    moment = std::move(part);
    return true;
  }
  return false;
}

ProgressCheck::Outlook ProgressCheck::outlook(const Moment& moment) {
  Outlook found;
  const FreeInputs* inputs = reductions.freeInputs;
  const auto consider = [&](TransitionId id) {
    found.settled = found.settled || system.transitions[id].fails;
    if (found.settled || !isAwaited(moment, id)) return;
    const bool again = contains(recurrent, id);
    BitField undecided;
    const auto known = inputs ? inputs->truth(id, moment.state.data(), moment.unknown, undecided)
                              : PartialTruth::True;
    if (known == PartialTruth::Unknown)
      (again ? found.open : found.openOther) = inputs->variableAt(undecided);
    if (known == PartialTruth::True && again) found.due.push_back(id);
    found.settled = found.settled || (known == PartialTruth::True && !again);
  };
  eachIn(inputs ? inputs->candidates(moment.state.data(), moment.enabled) : moment.enabled,
         consider);
  return found;
}

bool ProgressCheck::isAtUpperBound(const Moment& moment, TransitionId transition) {
  const auto& of = system.transitions[transition];
  if (of.clock == kNone || !of.interval.upper) return false;
  const Signature& signature = graph.timing.at(moment.signature);
  const auto at = static_cast<std::size_t>(std::ranges::lower_bound(signature.clocks, of.clock) -
                                           signature.clocks.begin());
  const Thresholds& reached = thresholds(moment.signature)[at];
  return reached.endsAtUpper && moment.levels[at] == reached.lower.size() &&
         upperBound(of.interval) == signature.invariants[at];
}

/// Whether time waits for the transition, or for one over which it has priority. Observers make no
/// difference.
bool ProgressCheck::isAwaited(const Moment& moment, TransitionId transition) {
  const auto waits = [&](TransitionId id) {
    return system.transitions[id].urgent || isAtUpperBound(moment, id);
  };
  if (waits(transition)) return true;
  if (!system.hasPriorities) return false;
  const auto unseen = system.transitions[transition].unseen;
  const TransitionId plain = unseen == kNone ? transition : unseen;
  bool goesFirst = false;
  eachIn(moment.enabled, [&](TransitionId id) {
    const auto& of = system.transitions[id];
    const auto has = [&](const auto& all) { return std::ranges::count(all, plain) > 0; };
    const bool lets = has(of.blockers) || has(of.laterBlockers);
    goesFirst = goesFirst || (lets && waits(id));
  });
  return goesFirst;
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

/// Whether a transition with priority can fire.
bool ProgressCheck::isBlocked(const Moment& moment, TransitionId transition) {
  const auto canGo = [&](TransitionId id) {
    return contains(moment.enabled, id) && canFire(moment, id);
  };
  const auto& of = system.transitions[transition];
  return std::ranges::any_of(of.blockers, canGo) || std::ranges::any_of(of.laterBlockers, canGo);
}

bool ProgressCheck::fireFrom(const Moment& moment, TransitionId transition, Moment& next) {
  next.state = moment.state;
  next.unknown = moment.unknown;
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
  return true;
}

/// A moment that is known needs no look at its variables.
StateId ProgressCheck::numberAfterStep(Moment& moment) {
  if (reductions.liveVariables) {
    makeKey(moment);
    if (const StateId known = moments.find(key.data()); known != kNone) return known;
    reductions.liveVariables->clean(moment.state.data());
  }
  return number(moment);
}

StateId ProgressCheck::number(const Moment& moment) {
  makeKey(moment);
  const auto [id, isNew] = moments.add(key.data());
  if (!isNew) return id;
  verdicts.push_back(Verdict::Unknown);
  metIn.push_back(0);
  openAt.push_back(kNone);
  return id;
}

void ProgressCheck::makeKey(const Moment& moment) {
  key.assign(levelsFrom + wordsOfLevels(system), 0);
  std::copy_n(moment.state.begin(), system.storedWords, key.begin());
  if (reductions.freeInputs) {
    for (std::size_t i = 0; i < system.storedWords; ++i) {
      key[i] &= ~moment.unknown[i];
      key[system.storedWords + i] = moment.unknown[i];
    }
  }
  for (std::size_t i = 0; i < moment.levels.size(); ++i)
    key[levelsFrom + i / kLevelsPerWord] |= Word{moment.levels[i]} << (i % kLevelsPerWord * 8);
}

void ProgressCheck::load(StateId id, Moment& moment) {
  const Word* stored = moments.at(id);
  moment.state.assign(system.words, 0);
  std::copy_n(stored, system.storedWords, moment.state.begin());
  if (reductions.freeInputs) {
    moment.unknown.assign(system.words, 0);
    std::copy_n(stored + system.storedWords, system.storedWords, moment.unknown.begin());
  }
  graph.enabling.compute(moment.state.data(), moment.enabled);
  moment.signature = graph.enabling.signature(moment.enabled, graph.timing);
  moment.levels.resize(graph.timing.at(moment.signature).clocks.size());
  for (std::size_t i = 0; i < moment.levels.size(); ++i)
    moment.levels[i] = static_cast<std::uint8_t>(stored[levelsFrom + i / kLevelsPerWord] >>
                                                 (i % kLevelsPerWord * 8));
}

/// Whether due steps lead from the moment to one where time passes, for all values of the unknown
/// free inputs. If that depends on an input, names it. All moments on a path to a good one are
/// good; if there is no path, all visited moments are bad, or open. What is unknown is the same on
/// the whole way, so an open moment that a later search meets leads to no good one either.
ProgressCheck::Found ProgressCheck::search(const Moment& first) {
  Moment moment = first;
  struct Seen {
    StateId moment;
    StateId from; ///< the place of the predecessor
  };
  std::vector<Seen> seen{{number(moment), kNone}};
  std::vector<StateId> todo{0};
  metIn[seen[0].moment] = ++searches;
  std::optional<std::uint32_t> open;
  std::optional<std::uint32_t> openOther;
  Moment next;
  while (!todo.empty()) {
    if (isStopped()) return {Verdict::Good}; // not known; the search ends
    const StateId place = todo.back();
    todo.pop_back();
    const StateId here = seen[place].moment;
    if (verdicts[here] == Verdict::Bad) continue;
    if (verdicts[here] == Verdict::Open) {
      open = openAt[here];
      continue;
    }
    Outlook ahead;
    if (verdicts[here] != Verdict::Good) {
      load(here, moment);
      ahead = outlook(moment);
    }
    if (ahead.isFine()) {
      for (StateId at = place; at != kNone; at = seen[at].from)
        verdicts[seen[at].moment] = Verdict::Good;
      return {Verdict::Good};
    }
    if (ahead.open) open = ahead.open;
    if (ahead.openOther) openOther = ahead.openOther;
    for (auto transition : ahead.due) {
      if (!canFire(moment, transition) || isBlocked(moment, transition)) continue;
      if (reductions.freeInputs) {
        if (auto touched = reductions.freeInputs->touchedBy(transition, moment.unknown)) {
          open = touched;
          continue;
        }
      }
      if (!fireFrom(moment, transition, next)) continue;
      const StateId id = numberAfterStep(next);
      if (metIn[id] == searches) continue;
      metIn[id] = searches;
      todo.push_back(static_cast<StateId>(seen.size()));
      seen.push_back({id, place});
    }
  }
  if (!open) open = openOther;
  if (open) {
    for (const auto& one : seen)
      if (verdicts[one.moment] == Verdict::Unknown) {
        verdicts[one.moment] = Verdict::Open;
        openAt[one.moment] = *open;
      }
    return {Verdict::Open, *open};
  }
  for (const auto& one : seen) verdicts[one.moment] = Verdict::Bad;
  return {Verdict::Bad};
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
