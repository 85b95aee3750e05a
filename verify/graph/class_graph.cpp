#include "verify/graph/class_graph.h"

#include "verify/limits.h"
#include "verify/state/state_layout.h"

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr std::size_t kMarkingsOfChunk = 128; ///< for each thread
constexpr std::size_t kStepsOfChunk = kBetweenGrowthChecks;
constexpr std::size_t kMarkingsAtOnce = 4;  ///< that a thread takes from the chunk
constexpr std::size_t kClaimsOfMarking = 4; ///< on average; markings with more need no claims

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
      state(of.words) {
  expanders.push_back(
      std::make_unique<MarkingExpander>(of, enabling, markings, watch, 0, to, shared));
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
  const std::vector<Word> first = initialState(system);
  if (ranks && ownerOf(*ranks, first) != ranks->self()) return;
  enabling.compute(first.data(), enabled);
  initial.marking = markings.add(first.data()).id;
  describe(enabled);
  initial.domain = domains.initial(signatures.at(initial.marking));
  enter(initial.marking, sets.single(initial.domain));
}

/// Expands what waits, until nothing is left here, or a limit is met.
void ClassGraph::explore() {
  try {
    while (!waiting.empty() || ready.entered < ready.markings.size()) {
      if (exchange) exchange->receive();
      takeChunk();
      prepareClaims();
      workTogether();
      if (!result.stopped.empty()) break;
      settleFresh();
      if (!failure.message.empty()) break;
    }
  } catch (const LimitMet& limit) {
    result.stopped = limit.which;
  }
  putBack();
}

void ClassGraph::workTogether() {
  if (jobs == 1) return work(0);
  const double begin = limits.seconds();
  if (gain.areThreadsFaster())
    team->inAll([this](std::size_t member) { work(member); });
  else
    work(0);
  gain.add(limits.seconds() - begin, fresh.markings.size());
}

/// Takes the markings that wait for the longest time.
void ClassGraph::takeChunk() {
  jobs = recorder || ranks ? 1 : limits.jobsFor(result.classes, waiting.size());
  while (expanders.size() < jobs)
    expanders.push_back(std::make_unique<MarkingExpander>(
        system, enabling, markings, limits, static_cast<std::uint32_t>(expanders.size()), recorder,
        ranks));
  if (jobs > 1 && !team) team.emplace(jobs);
  const std::size_t most = std::min(kMarkingsOfChunk * jobs, kStepsOfChunk / stepsOfMarking);
  const std::size_t count = std::min(waiting.size(), std::max<std::size_t>(most, 1));
  const auto end = waiting.begin() + static_cast<std::ptrdiff_t>(count);
  fresh.markings.assign(waiting.begin(), end);
  waiting.erase(waiting.begin(), end);
  fresh.expanded.resize(std::max(fresh.expanded.size(), count));
  fresh.makers.resize(fresh.expanded.size());
  next = 0;
}

void ClassGraph::prepareClaims() {
  RootTable& table = markings.roots;
  if (table.prepareClaims(kClaimsOfMarking * fresh.markings.size())) {
    table.startGrowth();
    if (jobs > 1)
      team->inAll([&](std::size_t member) { table.refill(member, team->size()); });
    else
      table.refill(0, 1);
  }
  claimants.resize(std::max(claimants.size(), table.claimCapacity()));
  for (auto& expander : expanders) expander->startChunk(claimants);
}

/// Fires the domains of the chunk before, and expands this one. \throw LimitMet
void ClassGraph::work(std::size_t member) try {
  if (member == 0) enterReady();
  expandFresh(member);
} catch (...) {
  next = fresh.markings.size(); // the others stop, too
  throw;
}

void ClassGraph::expandFresh(std::size_t member) {
  const std::size_t count = fresh.markings.size();
  for (std::size_t from = next.fetch_add(kMarkingsAtOnce); from < count;
       from = next.fetch_add(kMarkingsAtOnce)) {
    const std::size_t end = std::min(count, from + kMarkingsAtOnce);
    for (std::size_t i = from; i < end; ++i) {
      fresh.makers[i] = static_cast<std::uint32_t>(member);
      expanders[member]->expand(fresh.markings[i], fresh.expanded[i]);
    }
  }
  expanders[member]->finish();
}

/// Numbers the markings after the steps from the chunk, as if one marking were expanded after the
/// other.
void ClassGraph::settleFresh() {
  std::size_t steps = 0;
  for (std::size_t i = 0; i < fresh.markings.size(); ++i) {
    ExpandedMarking& expansion = fresh.expanded[i];
    steps += expansion.steps.size();
    failure = expansion.failure;
    if (!failure.message.empty()) return;
    for (auto& step : expansion.steps)
      if (step.marking == kNone && !step.isElsewhere) step.marking = numberOf(step, i);
  }
  if (!fresh.markings.empty()) stepsOfMarking = 1 + steps / fresh.markings.size();
  std::swap(ready, fresh);
  ready.entered = 0;
  fresh.markings.clear();
}

/// The number of a marking that had none when the step was made. \param at index in the chunk
std::uint32_t ClassGraph::numberOf(const MarkingStep& step, std::size_t at) {
  if (step.claim == kNone) {
    const auto [id, isNew] = markings.add(&fresh.expanded[at].words[step.words]);
    if (isNew) describe(expanders[fresh.makers[at]]->translate(step.signature, domains));
    return id;
  }
  const auto [id, isNew] = markings.roots.settle(step.claim);
  const Claimant& by = claimants[step.claim];
  if (isNew) describe(expanders[by.member]->translate(by.signature, domains));
  return id;
}

/// Ends both chunks: what is left of them waits again.
void ClassGraph::putBack() {
  const auto all = allWaiting();
  waiting.assign(all.begin(), all.end());
  fresh.markings.clear();
  ready.markings.clear();
  ready.entered = 0;
}

/// The markings with domains that were not fired, in their order.
std::vector<std::uint32_t> ClassGraph::allWaiting() const {
  std::vector<std::uint32_t> all(
      ready.markings.begin() + static_cast<std::ptrdiff_t>(ready.entered), ready.markings.end());
  all.insert(all.end(), fresh.markings.begin(), fresh.markings.end());
  all.insert(all.end(), waiting.begin(), waiting.end());
  return all;
}

/// Fires the domains of the chunk that is expanded, or as many as the limits allow.
void ClassGraph::enterReady() {
  for (; ready.entered < ready.markings.size(); ++ready.entered) {
    constexpr std::uint64_t kBetweenChecks = 16;
    if (entries++ % kBetweenChecks == 0) {
      result.stopped = limits.met(progress(), growth());
      if (!result.stopped.empty()) next = fresh.markings.size();
      if (!result.stopped.empty()) return;
      if (checkpoint && checkpoint->isDue()) save();
      if (exchange) exchange->receive();
    }
    if (sets.isCrowded()) removeUnusedSets();
    prefetchNext();
    enterNext();
  }
}

/// Asks the processor to load what the next marking needs.
void ClassGraph::prefetchNext() const {
  const std::size_t i = ready.entered + 1;
  if (i >= ready.markings.size()) return;
  for (const auto& step : ready.expanded[i].steps) {
    if (step.isElsewhere) continue;
    signatures.prefetch(step.marking);
    classes.prefetch(step.marking);
    expanded.prefetch(step.marking);
  }
}

/// Fires the domains of a marking that have come since it was expanded the last time.
void ClassGraph::enterNext() {
  const std::uint32_t id = ready.markings[ready.entered];
  const ExpandedMarking& expansion = ready.expanded[ready.entered];
  const SetId all = classes.at(id);
  pending = sets.without(all, expanded.at(id));
  expanded.set(id, all);
  signature = signatures.at(id);
  for (const auto& step : expansion.steps)
    if (step.isElsewhere)
      send(step);
    else
      fireDomains(id, step);
  noteDomains(possibleSets.add(expansion.possible).id, pending);
}

void ClassGraph::fireDomains(std::uint32_t source, const MarkingStep& step) {
  const auto image = images.of(pending, {signature, step.transition, signatures.at(step.marking)});
  result.transitions += image.fired;
  if (recorder) recordEdges(source, step);
  if (image.fired > 0) enter(step.marking, image.domains);
}

void ClassGraph::recordEdges(std::uint32_t source, const MarkingStep& step) {
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

std::uint32_t ClassGraph::addDomain(std::uint64_t key) {
  const auto count = static_cast<std::uint32_t>(domainKeys.size());
  auto found = domainTable.findOrAdd(mix(0, key), count,
                                     [&](std::uint32_t other) { return domainKeys[other] == key; });
  if (found == count) domainKeys.push_back(key);
  return found;
}

void ClassGraph::describe(const TransitionSet& allowed) {
  describe(signatureOf(allowed, system, enabling, domains));
}

/// Adds what belongs to the newest marking.
void ClassGraph::describe(std::uint32_t ofMarking) {
  signatures.push(ofMarking);
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
         waiting.size() * sizeof(std::uint32_t) + domainTable.bytes() + possibleSets.bytes() +
         domainKeys.capacity() * sizeof(std::uint64_t) + (recorder ? recorder->bytes() : 0) +
         (exchange ? exchange->bytes() : 0);
}

/// Bytes that the next few expansions may allocate at once.
std::uint64_t ClassGraph::growth() const {
  return markings.growth() + sets.growth() + images.growth() + noted.growth(sets.end()) +
         domains.growth() + domainTable.growth() + growthOf(domainKeys) + possibleSets.growth() +
         signatures.growth() + classes.growth() + expanded.growth();
}

Progress ClassGraph::progress() const {
  const std::size_t left = ready.markings.size() - ready.entered + fresh.markings.size();
  return {result.classes, result.markings, left + waiting.size(), bytes(), limits.seconds()};
}

} // namespace proskill::verify
