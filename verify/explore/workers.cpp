#include "verify/explore/workers.h"

#include "verify/reduce/live_variables.h"
#include "verify/reduce/stubborn_sets.h"
#include "verify/threads/translation.h"

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr NodeIndex kNodesOfChunk = 2048; ///< for each thread
constexpr std::size_t kChunkPieces = 32;  ///< for each thread: nodes that are expanded together
constexpr std::size_t kClaimsOfNode = 8;  ///< on average; nodes with more need no claims

} // namespace

class Workers::Worker {
public:
  /// Begins with the zones and caches of the graph.
  Worker(const System& of, const OpenGoals& goals, const Reductions& shared, ZoneGraph& in,
         const LimitWatch& watch)
      : system(of),
        graph(in),
        limits(watch),
        reductions(shared),
        timing(in.timing),
        expander(of, goals, reductions, in, timing, limits),
        claimer{in.states.roots, {}, 0},
        stored(of.storedWords) {
    if (shared.liveVariables)
      reductions.liveVariables = &liveVariables.emplace(*shared.liveVariables, limits);
    if (shared.stubbornSets)
      reductions.stubbornSets = &stubbornSets.emplace(*shared.stubbornSets, limits);
  }

  void expand(NodeIndex node, Expansion& to) {
    const StateId state = graph.stateOf(node);
    const ZoneId zone = graph.zoneOf(node);
    const SignatureId signature = graph.signatureOf(state);
    graph.states.read(state, stored.data(), nodes);
    expander.load(
        stored.data(),
        ownSignature.get(signature, [&] { return timing.adopt(graph.timing, signature); }),
        ownZone.get(zone, [&] { return timing.adopt(graph.timing.zones(), zone); }));
    expander.expand(all);
    claimer.node = node;
    expander.reduce(all, nodes, &claimer);
    keep(all, to);
  }

  void startChunk() { claimer.own = {}; }

  /// Replaces the own numbers by those of the graph, whose tables may grow.
  void translate(Expansion& expansion, Timing& to) {
    for (auto& it : expansion.successors) {
      it.signature = sharedSignature.get(it.signature,
                                         [&, own = it.signature] { return to.adopt(timing, own); });
      it.zone =
          sharedZone.get(it.zone, [&, own = it.zone] { return to.adopt(timing.zones(), own); });
    }
  }

private:
  /// Copies what is left of an expansion: mostly little, so that a chunk fits into a cache.
  void keep(Expansion& from, Expansion& to) const {
    to.successors = from.successors;
    to.words.clear();
    for (auto& it : to.successors) {
      if (it.known != kNone || it.claim != kNone) continue;
      const auto first = from.words.begin() + static_cast<std::ptrdiff_t>(it.state);
      it.state = to.words.size();
      to.words.insert(to.words.end(), first, first + system.words);
    }
    to.notices = std::move(from.notices);
    to.transitions = from.transitions;
    to.failure = from.failure;
    to.failureOrigin = from.failureOrigin;
  }

  const System& system;
  const ZoneGraph& graph;
  LimitWatch limits;
  Reductions reductions;
  std::optional<LiveVariables> liveVariables;
  std::optional<StubbornSets> stubbornSets;
  Timing timing;
  Expander expander;
  Claimer claimer;
  std::vector<Word> stored;
  StateTree::Path nodes; ///< of the state that is expanded
  Expansion all;         ///< all that is possible from a node
  Translation ownZone;
  Translation ownSignature;
  Translation sharedZone;
  Translation sharedSignature;
};

Workers::Workers(const System& system, const OpenGoals& goals, const Reductions& reductions,
                 ZoneGraph& to, const LimitWatch& limits, unsigned jobs)
    : graph(to), team(jobs) {
  while (all.size() < team.size())
    all.push_back(std::make_unique<Worker>(system, goals, reductions, to, limits));
}

Workers::~Workers() = default;

const Expansion& Workers::expansionOf(NodeIndex node) {
  if (!hasExpanded(node)) {
    first = node;
    end = endOfChunk(first);
    expandChunk();
  }
  Expansion& made = chunk[node - first];
  all[makers[node - first]]->translate(made, graph.timing);
  return made;
}

NodeIndex Workers::endOfChunk(NodeIndex node) const {
  return std::min(graph.size(), node + kNodesOfChunk * static_cast<NodeIndex>(all.size()));
}

/// Expands the nodes of the chunk in all threads.
void Workers::expandChunk() {
  chunk.resize(std::max<std::size_t>(chunk.size(), end - first));
  makers.resize(chunk.size());
  next = first;
  prepareClaims();
  team.inAll([this](std::size_t worker) { work(worker); });
}

void Workers::prepareClaims() {
  RootTable& table = graph.states.roots;
  if (table.prepareClaims(kClaimsOfNode * (end - first))) {
    table.startGrowth();
    team.inAll([&](std::size_t worker) { table.refill(worker, all.size()); });
  }
  for (auto& worker : all) worker->startChunk();
}

/// Takes nodes of the chunk until none is left, or until a limit is met.
void Workers::work(std::size_t worker) try {
  // neighbours have zones in common, so they are expanded by the same thread
  const NodeIndex atOnce =
      std::max(1U, (end - first) / static_cast<NodeIndex>(all.size() * kChunkPieces));
  for (NodeIndex from = next.fetch_add(atOnce); from < end; from = next.fetch_add(atOnce)) {
    const NodeIndex to = std::min(end, from + atOnce);
    for (NodeIndex node = from; node < to; ++node) {
      makers[node - first] = static_cast<std::uint32_t>(worker);
      if (!graph.isSubsumed(node)) all[worker]->expand(node, chunk[node - first]);
    }
  }
} catch (...) {
  next = end; // the others stop, too
  throw;
}

} // namespace proskill::verify
