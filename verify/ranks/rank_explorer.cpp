#include "verify/ranks/rank_explorer.h"

#include "verify/checkpoint/parts.h"
#include "verify/explore/conclude.h"
#include "verify/reduce/live_variables.h"

#include <algorithm>
#include <cassert>

/// How a rank expands its nodes of a level, and what it receives meanwhile.
namespace proskill::verify {

RankExplorer::RankExplorer(const System& of, const std::vector<Goal>& asked, const Reductions& with,
                           Extrapolation how, LimitWatch& watch, Ranks& shared, OnFound tell)
    : system(of),
      reductions(with),
      limits(watch),
      ranks(shared),
      onFound(std::move(tell)),
      graph(of, with.dropped, how),
      walker(of, graph.enabling, with),
      goals{asked, std::vector<bool>(asked.size()), 0},
      expander(of, goals, with, graph, graph.timing, watch),
      pathSteps(of, with, walker, expander),
      exchange(shared, [this](unsigned from, CheckpointReader& to) { receive(from, to); }),
      candidates(of.storedWords),
      recentlySent(of.storedWords),
      lastSent(shared.count(), std::vector<Word>(of.storedWords)),
      stored(of.storedWords),
      received(of.storedWords) {
  result.goals.resize(asked.size());
  open = static_cast<std::size_t>(std::ranges::count_if(asked, [](const Goal& goal) {
    return goal.kind != GoalKind::Unsupported && goal.kind != GoalKind::Run;
  }));
}

Explored RankExplorer::run() {
  auto& statistics = result.statistics;
  exploreWithinLimits(statistics, [this] { start(); });
  for (;;) {
    exchange.finishRound();
    settle();
    if (isOver()) break;
    exploreWithinLimits(statistics, [this] { expandLevel(); });
  }
  conclude();
  return std::move(result);
}

/// Every rank computes the initial node, and one of them keeps it, or the error on the way to it.
void RankExplorer::start() {
  expander.start(work);
  const bool isReached = !work.successors.empty();
  if (isReached && reductions.liveVariables) reductions.liveVariables->clean(work.words.data());
  if ((isReached ? ownerOf(work.words.data()) : 0) == ranks.self()) store({});
}

/// \throw LimitMet
void RankExplorer::expandLevel() {
  constexpr NodeIndex kBetweenChecks = 8;
  const NodeIndex end = graph.size();
  for (NodeIndex count = 0; first < end && result.failure.empty(); ++count, ++first) {
    if (count % kBetweenChecks == 0) checkLimits();
    if (count % kBetweenChecks == 0) exchange.receive();
    if (!graph.isSubsumed(first)) expand(first);
  }
}

void RankExplorer::checkLimits() {
  if (auto limit = limits.met(progress(), graph.growth()); !limit.empty())
    throw LimitMet{std::move(limit)};
}

void RankExplorer::expand(NodeIndex node) {
  const StateId state = graph.stateOf(node);
  graph.states.read(state, stored.data());
  expander.load(stored.data(), graph.signatureOf(state), graph.zoneOf(node));
  expander.expand(work);
  if (reductions.liveVariables)
    for (const auto& it : work.successors)
      reductions.liveVariables->clean(work.words.data() + it.state);
  store({ranks.self(), node});
}

/// Keeps what was found, or sends it to those to whom it belongs.
void RankExplorer::store(NodePlace from) {
  for (const auto& notice : work.notices) {
    if (!goals.found[notice.goal]) finds.push_back({notice.goal, from, notice.steps});
    goals.found[notice.goal] = true;
  }
  result.statistics.transitions += work.transitions;
  result.failure = work.failure;
  result.failureOrigin = work.failureOrigin;
  for (const auto& it : work.successors) {
    const Word* words = work.words.data() + it.state;
    const unsigned owner = ownerOf(words);
    if (owner != ranks.self())
      sendOnce(owner, it, from, words);
    else if (!isCovered(words, graph.timing.zones().matrix(it.zone)))
      candidates.add(words, {0, it.zone, from, it.transition});
  }
}

unsigned RankExplorer::ownerOf(const Word* state) const {
  const std::uint64_t hash = hashOfAll(std::span(state, system.storedWords));
  return static_cast<unsigned>((hash >> 32) * ranks.count() >> 32);
}

/// Skips what the owner already has because it was sent lately.
void RankExplorer::sendOnce(unsigned to, const Successor& successor, NodePlace from,
                            const Word* words) {
  if (recentlySent.note(words, successor.zone)) send(to, successor, from, words);
}

/// Most states of a message differ little from the one before.
void RankExplorer::send(unsigned to, const Successor& successor, NodePlace from,
                        const Word* words) {
  auto& last = lastSent[to];
  if (exchange.isNew(to)) std::ranges::fill(last, 0);
  exchange.add(to, [&](CheckpointWriter& record) {
    record.number(from.node);
    record.number(successor.transition + 1U);
    writeState(record, last.data(), words, system.storedWords);
    const auto& zones = graph.timing.zones();
    writeZone(record, zones.dimension(successor.zone), zones.matrix(successor.zone));
    std::copy_n(words, last.size(), last.begin());
  });
}

/// A rank that has met a limit still empties its mailbox, so that the others can finish the level.
void RankExplorer::receive(unsigned from, CheckpointReader& records) {
  auto& stopped = result.statistics.stopped;
  if (stopped.empty()) stopped = limits.met(progress(), graph.growth());
  if (!stopped.empty()) return;
  std::ranges::fill(received, 0);
  while (records.flag()) receiveRecord(from, records);
}

void RankExplorer::receiveRecord(unsigned from, CheckpointReader& records) {
  const NodePlace parent{from, static_cast<NodeIndex>(records.number())};
  const auto step = static_cast<TransitionId>(records.number() - 1);
  readState(records, received.data(), system.storedWords);
  const auto zone = readZone(records, static_cast<std::uint32_t>(system.clocks.size() + 1));
  assert(zone);
  if (!isCovered(received.data(), zone->matrix()))
    candidates.add(received.data(), {0, graph.timing.adopt(*zone), parent, step});
}

/// Whether the graph covers a zone; then it does for ever.
bool RankExplorer::isCovered(const Word* state, std::span<const Bound> zone) {
  const auto root = graph.states.findRoot(state, path);
  const StateId known = root ? graph.states.find(*root) : kNone;
  return known != kNone && graph.covers(known, zone, reductions.inclusion);
}

/// Makes nodes of the candidates.
void RankExplorer::settle() {
  for (const auto& candidate : candidates.inOrder(graph.timing.zones())) addNode(candidate);
  candidates.clear();
}

void RankExplorer::addNode(const Candidate& candidate) {
  const Word* words = candidates.stateOf(candidate);
  const auto [state, isNew] = graph.states.add(words);
  if (isNew)
    graph.addState(signatureOf({words, words + system.storedWords}));
  else if (graph.covers(state, graph.timing.zones().matrix(candidate.zone), reductions.inclusion))
    return;
  graph.addNode(state, candidate.zone, candidate.step, reductions.inclusion);
  parentRanks.push(candidate.from.rank + 1);
  parents.push(candidate.from.node);
}

SignatureId RankExplorer::signatureOf(const std::vector<Word>& state) {
  whole = state;
  whole.resize(system.words);
  graph.enabling.compute(whole.data(), enabled);
  return walker.signature(whole, enabled, graph.timing);
}

} // namespace proskill::verify
