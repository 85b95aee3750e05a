#include "verify/ctl/lost_states.h"

#include "verify/explore/arrivals.h"
#include "verify/reduce/live_variables.h"
#include "verify/state/evaluate.h"
#include "verify/state/exact_zone.h"

#include <algorithm>

namespace proskill::verify {

LostStates::LostStates(const System& of, const Reductions& with, NodeId wanted, Explorer& explored,
                       LimitWatch& watch)
    : system(of),
      reductions(with),
      condition(wanted),
      explorer(explored),
      graph(explored.exploredWithNumbers()),
      limits(watch),
      walker(of, graph.enabling, with),
      count(graph.states.size()),
      nodesOf(count),
      arcsTo(count),
      good(count) {
  for (NodeIndex i = 0; i < graph.size(); ++i)
    if (!graph.isSubsumed(i)) nodesOf[graph.stateOf(i)].push_back(i);
}

std::optional<Evidence> LostStates::find() {
  findArcs();
  while (!todo.empty()) {
    const auto [state, zone] = std::move(todo.back());
    todo.pop_back();
    for (const Arc& arc : arcsTo[state]) growBefore(arc, zone);
  }
  for (NodeIndex i = 0; i < graph.size(); ++i) {
    const Good& at = good[graph.stateOf(i)];
    if (graph.isSubsumed(i) || at.all || !at.zones.outside(zoneOf(i))) continue;
    auto evidence = evidenceAt(i);
    if (!evidence) throw LimitMet{"internal error: a lost state without a run to it"};
    return evidence;
  }
  return std::nullopt;
}

void LostStates::check() {
  limits.check();
  constexpr std::uint64_t kBetweenChecks = 256;
  if (++zonesAdded % kBetweenChecks != 0) return;
  auto met = limits.met({.classes = graph.size(),
                         .markings = graph.states.size(),
                         .waiting = todo.size(),
                         .bytes = graph.bytes(),
                         .seconds = limits.seconds()});
  if (!met.empty()) throw LimitMet{std::move(met)};
}

// --- Steps between stored states

void LostStates::findArcs() {
  for (StateId state = 0; state < count; ++state) {
    check();
    findArcsOf(state);
  }
}

void LostStates::findArcsOf(StateId state) {
  loaded.assign(system.words, 0);
  graph.states.read(state, loaded.data());
  if (holdsAt(system, condition, {loaded.data(), nullptr, nullptr})) growAll(state);
  graph.enabling.compute(loaded.data(), enabled);
  bool ends = false; // a guard fails, which ends the run
  eachIn(enabled, [&](TransitionId id) { ends = ends || system.transitions[id].fails; });
  if (ends) return;
  const std::vector<Word> here = loaded;
  const TransitionSet all = enabled;
  if (!reductions.freeInputs) {
    eachIn(all, [&](TransitionId transition) {
      if (!graph.enabling.isBlocked(transition, all)) follow(state, transition, here);
    });
    return;
  }
  const FreeInputs& open = *reductions.freeInputs;
  std::vector<Word> chosen = here;
  eachIn(open.candidates(chosen.data(), all), [&](TransitionId transition) {
    if (open.staysWithin(transition, here.data())) return;
    open.eachFiring(transition, chosen.data(), [&] {
      follow(state, transition, chosen);
      return false;
    });
  });
}

/// Notes what a step shows, and where it leads to. \param chosen the state, with some values of its
/// open variables
void LostStates::follow(StateId state, TransitionId transition, const std::vector<Word>& chosen) {
  limits.check();
  Walk walk = walker.from(chosen);
  log.clear();
  if (fire(system, transition, walk.state.data(), log) != Outcome::Done) return;
  if (shows(chosen, walk.state)) addPast(state, transition, valuesOf(state));
  graph.enabling.update(transition, walk.state.data(), walk.enabled);
  walker.normalise(walk);
  const Arrivals arrivals(walker, graph.timing, limits);
  Arrival there = arrivals.at(std::move(walk));
  auto clocks = graph.timing.kept(graph.signatureOf(state), transition, there.chain.front());
  for (std::size_t i = 0; i < there.alone.size(); ++i) {
    auto next = graph.timing.kept(there.chain[i], there.alone[i], there.chain[i + 1]);
    for (auto& clock : next) clock = clock == 0 ? 0 : clocks[clock - 1];
    clocks = std::move(next);
  }
  if (reductions.liveVariables) reductions.liveVariables->clean(there.state.data());
  const auto root = graph.states.findRoot(there.state.data(), path);
  const StateId to = root ? graph.states.find(*root) : kNone;
  if (to != kNone) arcsTo[to].push_back({state, transition, numberOf(std::move(clocks))});
}

std::uint32_t LostStates::numberOf(std::vector<std::uint32_t> clocks) {
  const auto next = static_cast<std::uint32_t>(kept.size());
  const auto [at, isNew] = numbers.emplace(std::move(clocks), next);
  if (isNew) kept.push_back(at->first);
  return at->second;
}

bool LostStates::shows(const std::vector<Word>& before, const std::vector<Word>& after) const {
  Bits events;
  for (auto event : log.events) events.insert(event);
  return holdsAt(system, condition, {before.data(), after.data(), &events});
}

// --- Predecessors

/// All values that the state allows.
Dbm LostStates::valuesOf(StateId state) const {
  const Signature& signature = graph.timing.at(graph.signatureOf(state));
  const auto clocks = static_cast<std::uint32_t>(signature.clocks.size());
  Dbm all = allValues(clocks);
  for (std::uint32_t i = 0; i < clocks; ++i) all.constrain(i + 1, 0, signature.invariants[i]);
  return all;
}

/// The values from which the steps of an arc lead into a zone of its target.
std::optional<Dbm> LostStates::before(const Arc& arc, const Dbm& zone) const {
  const auto& from = kept[arc.clocks];
  const auto old = [&](std::uint32_t i) { return i == 0 ? 0 : from[i - 1]; };
  Dbm made = valuesOf(arc.from);
  for (std::uint32_t i = 0; i < zone.dimension(); ++i)
    for (std::uint32_t j = 0; j < zone.dimension(); ++j) {
      const Bound limit = zone.at(i, j);
      const bool fits = old(i) == old(j)
                            ? limit >= kZero
                            : limit == kInfinite || made.constrain(old(i), old(j), limit);
      if (!fits) return std::nullopt;
    }
  return made;
}

void LostStates::addPast(StateId state, TransitionId transition, std::optional<Dbm> zone) {
  const SignatureId signature = graph.signatureOf(state);
  if (!zone || !graph.timing.allow(*zone, signature, transition)) return;
  if (!graph.timing.at(signature).urgent) zone->startBefore();
  grow(state, std::move(*zone));
}

void LostStates::growBefore(const Arc& arc, const Dbm& zone) {
  if (!good[arc.from].all) addPast(arc.from, arc.transition, before(arc, zone));
}

void LostStates::grow(StateId state, Dbm zone) {
  check();
  Good& at = good[state];
  if (at.all || at.zones.includesZone(zone)) return;
  at.zones.add(zone);
  if (hasAll(state)) return growAll(state);
  todo.emplace_back(state, std::move(zone));
}

void LostStates::growAll(StateId state) {
  good[state].all = true;
  good[state].zones.clear();
  todo.emplace_back(state, valuesOf(state));
}

bool LostStates::hasAll(StateId state) const {
  return std::ranges::none_of(nodesOf[state], [&](NodeIndex node) {
    return good[state].zones.outside(zoneOf(node)).has_value();
  });
}

// --- Evidence

/// The stored zone may be larger than what is reached by the steps to it. So the lost values are
/// found in the exact zone after these steps.
std::optional<Evidence> LostStates::evidenceAt(NodeIndex node) {
  Evidence evidence{.steps = explorer.pathTo(node)};
  const auto reached = exactZone(system, evidence.steps, limits.asCheck(), reductions.dropped);
  const StateId state = graph.stateOf(node);
  const auto& clocks = graph.timing.at(graph.signatureOf(state)).clocks;
  if (!reached || reached->clocks != clocks) return std::nullopt;
  const auto lost = good[state].zones.outside(reached->zone);
  if (!lost) return std::nullopt;
  const auto clockAt = [&](std::uint32_t i) { return i == 0 ? kNone : clocks[i - 1]; };
  for (std::uint32_t i = 0; i < lost->dimension(); ++i)
    for (std::uint32_t j = 0; j < lost->dimension(); ++j)
      if (lost->at(i, j) < reached->zone.at(i, j))
        evidence.differences.push_back({clockAt(i), clockAt(j), lost->at(i, j)});
  return evidence;
}

} // namespace proskill::verify
