#include "verify/graph/class_graph.h"

#include "verify/limits.h"
#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <algorithm>
#include <tuple>

namespace proskill::verify {

namespace {

/// Whether a path may end in more than one location.
bool branches(const Path& path) {
  std::optional<std::uint32_t> first;
  for (const auto& instruction : path.code) {
    const bool isEnd = instruction.kind == InstructionKind::To;
    if (!isEnd && instruction.kind != InstructionKind::Loop) continue;
    const std::uint32_t end = isEnd ? instruction.last : path.location;
    if (first.value_or(end) != end) return true;
    first = end;
  }
  return false;
}

} // namespace

ClassGraph::ClassGraph(const System& of, LimitWatch& watch, GraphRecorder* to, Checkpoint* kept,
                       Ranks* shared)
    : system(of),
      limits(watch),
      recorder(to),
      checkpoint(kept),
      ranks(shared),
      enabling(of),
      domains(of),
      images(domains, sets),
      markings(of),
      state(of.words),
      next(of.words),
      received(of.words) {
  for (const auto& transition : of.transitions)
    branching.push_back(std::ranges::any_of(transition.parts,
                                            [&](PathId part) { return branches(of.paths[part]); }));
  if (!ranks) return;
  exchange.emplace(*ranks, [this](unsigned, CheckpointReader& records) { receive(records); });
  lastSent.assign(ranks->count(), std::vector<Word>(of.words));
}

std::expected<Exploration, Unsupported> ClassGraph::run() {
  start();
  do explore();
  while (ranks && isRoundLeft());
  if (ranks) shareEnd();
  if (!failure.message.empty()) return std::unexpected(failure);
  result.complete = result.stopped.empty();
  if (checkpoint && !result.complete) save();
  if (checkpoint && result.complete) checkpoint->finish();
  result.domains = domainKeys.size();
  result.bytes = bytes();
  if (ranks) addUp();
  result.seconds = limits.seconds();
  return result;
}

/// \throw LimitMet
void ClassGraph::start() {
  if (checkpoint && checkpoint->earlier()) {
    resume(*checkpoint->earlier());
    failure.message = checkpoint->endEarlier(result.classes);
    return;
  }
  std::vector<Word> first = initialState(system);
  if (isElsewhere(first)) return;
  enabling.compute(first.data(), enabled);
  initial.marking = markings.add(first.data()).id;
  describe(enabled);
  initial.domain = domains.initial(signatures.at(initial.marking));
  enter(initial.marking, sets.single(initial.domain));
}

/// Expands what waits, until nothing is left here, or a limit is met.
void ClassGraph::explore() {
  for (std::uint64_t count = 0; !waiting.empty(); ++count) {
    constexpr std::uint64_t kBetweenChecks = 16;
    if (count % kBetweenChecks == 0 && result.stopped.empty())
      result.stopped = limits.met(progress(), growth());
    if (!result.stopped.empty() || !failure.message.empty()) return;
    if (checkpoint && count % kBetweenChecks == 0 && checkpoint->isDue()) save();
    if (exchange && count % kBetweenChecks == 0) exchange->receive();
    if (sets.isCrowded()) removeUnusedSets();
    const std::uint32_t oldest = waiting.front();
    waiting.pop_front();
    expand(oldest);
  }
}

void ClassGraph::expand(std::uint32_t id) {
  const SetId all = classes.at(id);
  pending = sets.without(all, expanded.at(id));
  expanded.set(id, all);
  signature = signatures.at(id);
  markings.read(id, state.data(), path);
  enabling.compute(state.data(), enabled);
  fireAll();
  findTargets();
  enterTargets(id);
  noteDomains(numberOfPossible(), pending);
}

/// Computes the markings after all transitions that are possible in the marking.
void ClassGraph::fireAll() {
  possible.clear();
  successors.clear();
  successorStates.clear();
  eachIn(enabled, [&](TransitionId transition) {
    if (enabling.isBlocked(transition, enabled) || !fireFromState(transition)) return;
    if (isElsewhere(next)) return sendSuccessors(transition);
    successors.push_back({transition, kNone, 0});
    successorStates.insert(successorStates.end(), next.begin(), next.end());
    if (recorder) successors.back().label = recorder->label(transition, log);
  });
}

/// Computes the marking after a transition, and notes what was possible. \return whether it is
bool ClassGraph::fireFromState(TransitionId transition) {
  next = state;
  log.clear();
  const Outcome outcome =
      recorder ? fire(system, transition, next.data(), log) : fire(system, transition, next.data());
  if (outcome == Outcome::Failed) noteFailure(transition);
  if (outcome != Outcome::Done) return false;
  notePossible(transition, next.data());
  return true;
}

/// Says why a transition cannot be fired from the marking that is expanded.
void ClassGraph::noteFailure(TransitionId transition) {
  next = state;
  log.clear();
  std::ignore = fire(system, transition, next.data(), log);
  failure = {log.failure, log.origins.empty() ? 0 : log.origins.back()};
}

void ClassGraph::notePossible(TransitionId transition, const Word* after) {
  possible.push_back(transition);
  if (!branching[transition]) return;
  for (auto part : system.transitions[transition].parts) {
    const auto& instance = system.instances[system.paths[part].instance];
    possible.push_back(static_cast<std::uint32_t>(readCell(system, instance.location, after)));
  }
}

/// Numbers the markings after the transitions. What they need from memory is asked for early.
void ClassGraph::findTargets() {
  const auto& roots = markings.rootsOf(successorStates, system.words, path);
  for (const auto& root : roots) markings.roots.prefetchSlot(root);
  for (const auto& root : roots) markings.roots.prefetchState(root);
  for (std::size_t i = 0; i < successors.size(); ++i) {
    Successor& step = successors[i];
    const auto [id, isNew] = markings.roots.add(roots[i]);
    step.marking = id;
    if (isNew) {
      nextEnabled = enabled;
      enabling.update(step.transition, &successorStates[i * system.words], nextEnabled);
      describe(nextEnabled);
    }
    signatures.prefetch(id);
    classes.prefetch(id);
    expanded.prefetch(id);
  }
}

/// Fires the transitions from the pending domains.
void ClassGraph::enterTargets(std::uint32_t source) {
  for (const auto& step : successors) {
    const auto image =
        images.of(pending, {signature, step.transition, signatures.at(step.marking)});
    result.transitions += image.fired;
    if (recorder) recordEdges(source, step);
    if (image.fired > 0) enter(step.marking, image.domains);
  }
}

void ClassGraph::recordEdges(std::uint32_t source, const Successor& step) {
  sets.eachIn(pending, [&](ZoneId domain) {
    const ZoneId after =
        domains.after(domain, signature, step.transition, signatures.at(step.marking));
    if (after != kNone) recorder->edge({source, domain}, step.label, {step.marking, after});
  });
}

/// Counts domains: the sets of possible transitions and their targets.
void ClassGraph::noteDomains(std::uint32_t possibleSet, SetId set) {
  const Memo::Key key{set, possibleSet, 0, 0};
  if (set == NumberSets::kEmpty || noted.find(key)) return;
  noted.fit(sets.end());
  noted.put(key, {});
  if (!sets.isLeaf(set)) {
    const auto [left, right] = sets.partsOf(set);
    noteDomains(possibleSet, left);
    return noteDomains(possibleSet, right);
  }
  sets.eachIn(set, [&](ZoneId domain) { addDomain(std::uint64_t{possibleSet} << 32 | domain); });
}

std::uint32_t ClassGraph::numberOfPossible() {
  std::uint64_t hash = 0;
  for (auto number : possible) hash = mix(hash, number);
  const auto fresh = static_cast<std::uint32_t>(possibleSets.size());
  auto set = possibleTable.findOrAdd(
      hash, fresh, [&](std::uint32_t other) { return possibleSets[other] == possible; });
  if (set == fresh) possibleSets.push_back(possible);
  return set;
}

std::uint32_t ClassGraph::addDomain(std::uint64_t key) {
  const auto count = static_cast<std::uint32_t>(domainKeys.size());
  auto found = domainTable.findOrAdd(mix(0, key), count,
                                     [&](std::uint32_t other) { return domainKeys[other] == key; });
  if (found == count) domainKeys.push_back(key);
  return found;
}

std::uint32_t ClassGraph::signatureOf(const TransitionSet& allowed) {
  std::vector<TransitionId> clocked;
  eachIn(allowed, [&](TransitionId transition) {
    if (system.transitions[transition].clock != kNone) clocked.push_back(transition);
  });
  return domains.signature(enabling.isUrgent(allowed), clocked);
}

/// Adds what belongs to the newest marking.
void ClassGraph::describe(const TransitionSet& allowed) {
  signatures.push(signatureOf(allowed));
  classes.push(NumberSets::kEmpty);
  expanded.push(NumberSets::kEmpty);
}

/// Adds classes to a marking.
void ClassGraph::enter(std::uint32_t marking, SetId more) {
  const SetId before = classes.at(marking);
  const SetId after = sets.unite(before, more);
  if (after == before) return;
  if (before == NumberSets::kEmpty) ++result.markings; // others are possible except for time
  result.classes += sets.sizeOf(after) - sets.sizeOf(before);
  if (before == expanded.at(marking)) waiting.push_back(marking);
  classes.set(marking, after);
}

void ClassGraph::removeUnusedSets() {
  std::vector<bool> needed(sets.end());
  for (std::size_t i = 0; i < classes.size(); ++i)
    needed[classes.at(i)] = needed[expanded.at(i)] = true;
  const auto moved = sets.removeUnused(std::move(needed));
  for (std::size_t i = 0; i < classes.size(); ++i) {
    classes.set(i, moved[classes.at(i)]);
    expanded.set(i, moved[expanded.at(i)]);
  }
  images.forget();
  noted.clear();
}

std::uint64_t ClassGraph::bytes() const {
  return markings.bytes() + sets.bytes() + images.bytes() + domains.bytes() + noted.bytes() +
         signatures.bytes() + classes.bytes() + expanded.bytes() +
         waiting.size() * sizeof(std::uint32_t) + domainTable.bytes() +
         domainKeys.capacity() * sizeof(std::uint64_t) + (recorder ? recorder->bytes() : 0) +
         (exchange ? exchange->bytes() : 0);
}

/// Bytes that the next few expansions may allocate at once.
std::uint64_t ClassGraph::growth() const {
  return markings.growth() + sets.growth() + images.growth() + noted.growth(sets.end()) +
         domains.growth() + domainTable.growth() + growthOf(domainKeys) + possibleTable.growth() +
         growthOf(possibleSets);
}

Progress ClassGraph::progress() const {
  return {result.classes, result.markings, waiting.size(), bytes(), limits.seconds()};
}

} // namespace proskill::verify
