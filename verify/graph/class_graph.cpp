#include "verify/graph/class_graph.h"

#include "verify/limits.h"
#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

namespace proskill::verify {

ClassGraph::ClassGraph(const System& of, LimitWatch& watch, GraphRecorder* to, Checkpoint* kept,
                       Ranks* shared)
    : system(of),
      limits(watch),
      recorder(to),
      checkpoint(kept),
      ranks(shared),
      enabling(of),
      domains(of),
      markings(of),
      state(of.words),
      received(of.words) {
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
  const std::uint32_t marking = add(first, enabled);
  initial = {marking, domains.initial(info[marking].signature)};
  enter(initial.marking, initial.domain);
}

/// Expands what waits, until nothing is left here, or a limit is met.
void ClassGraph::explore() {
  for (std::uint64_t count = 0; !waiting.empty(); ++count) {
    constexpr std::uint64_t kBetweenChecks = 64;
    if (count % kBetweenChecks == 0 && result.stopped.empty())
      result.stopped = limits.met(progress());
    if (!result.stopped.empty() || !failure.message.empty()) return;
    if (checkpoint && count % kBetweenChecks == 0 && checkpoint->isDue()) save();
    if (exchange && count % kBetweenChecks == 0) exchange->receive();
    const std::uint32_t oldest = waiting.front();
    waiting.pop_front();
    expand(oldest);
  }
}

void ClassGraph::expand(std::uint32_t id) {
  info[id].waits = false;
  const auto all = classes.at(id);
  pending.assign(all.begin() + info[id].done, all.end());
  info[id].done = static_cast<std::uint32_t>(all.size());
  markings.read(id, state.data());
  enabling.compute(state.data(), enabled);
  possible.clear();
  eachIn(enabled, [&](TransitionId transition) {
    if (!enabling.isBlocked(transition, enabled)) follow(id, transition);
  });
  countDomains();
}

/// Counts domains: the sets of possible transitions and their targets.
void ClassGraph::countDomains() {
  const std::uint64_t set = numberOfPossible();
  for (auto domain : pending) addDomain(set << 32 | domain);
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

/// Fires a transition from every pending class.
void ClassGraph::follow(std::uint32_t source, TransitionId transition) {
  const std::uint32_t signature = info[source].signature;
  if (!fireFromState(transition)) return;
  if (isElsewhere(next)) return sendSuccessors(signature, transition);
  const std::uint32_t target = add(next, nextEnabled);
  const std::uint32_t label = recorder ? recorder->label(transition, log) : 0;
  for (auto domain : pending) {
    const ZoneId after = domains.after(domain, signature, transition, info[target].signature);
    if (after == kNone) continue;
    ++result.transitions;
    if (recorder) recorder->edge({source, domain}, label, {target, after});
    enter(target, after);
  }
}

/// Computes the marking after a transition, and notes what was possible. \return whether it is
bool ClassGraph::fireFromState(TransitionId transition) {
  next = state;
  nextEnabled = enabled;
  log.clear();
  const Outcome outcome = fire(system, transition, next.data(), log);
  if (outcome == Outcome::Failed)
    failure = {log.failure, log.origins.empty() ? 0 : log.origins.back()};
  if (outcome != Outcome::Done) return false;
  possible.push_back(transition);
  for (auto part : system.transitions[transition].parts) {
    const auto& instance = system.instances[system.paths[part].instance];
    possible.push_back(
        static_cast<std::uint32_t>(readCell(system, instance.location, next.data())));
  }
  enabling.update(transition, next.data(), nextEnabled);
  return true;
}

std::uint32_t ClassGraph::signatureOf(const TransitionSet& allowed) {
  std::vector<TransitionId> clocked;
  eachIn(allowed, [&](TransitionId transition) {
    if (system.transitions[transition].clock != kNone) clocked.push_back(transition);
  });
  return domains.signature(enabling.isUrgent(allowed), clocked);
}

std::uint32_t ClassGraph::add(const std::vector<Word>& marking, const TransitionSet& allowed) {
  auto [id, isNew] = markings.add(marking.data());
  if (isNew) describe(allowed);
  return id;
}

/// Adds what belongs to the newest marking.
void ClassGraph::describe(const TransitionSet& allowed) {
  classes.add();
  info.push_back({signatureOf(allowed), 0, false});
}

void ClassGraph::enter(std::uint32_t marking, ZoneId domain) {
  if (classes.at(marking).empty()) ++result.markings; // others are possible except for time
  if (!classes.insert(marking, domain)) return;
  ++result.classes;
  if (info[marking].waits) return;
  info[marking].waits = true;
  waiting.push_back(marking);
}

std::uint64_t ClassGraph::bytes() const {
  return markings.bytes() + classes.bytes() + domains.bytes() + info.capacity() * sizeof(Marking) +
         waiting.size() * sizeof(std::uint32_t) + domainTable.bytes() +
         domainKeys.capacity() * sizeof(std::uint64_t) + (recorder ? recorder->bytes() : 0) +
         (exchange ? exchange->bytes() : 0);
}
Progress ClassGraph::progress() const {
  return {result.classes, result.markings, waiting.size(), bytes(), limits.seconds()};
}

} // namespace proskill::verify
