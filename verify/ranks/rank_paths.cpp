#include "verify/checkpoint/parts.h"
#include "verify/ranks/rank_explorer.h"

#include <algorithm>

/// Paths whose nodes belong to different ranks.
namespace proskill::verify {

/// A node of a path, as its rank describes it to the others.
struct RankExplorer::Hop {
  std::vector<Word> state;
  Dbm zone;
  TransitionId step = kNone;
  NodePlace parent;
};

/// From the node back to the initial one. All ranks read what the owner of each node says, so all
/// know whom to ask next.
std::vector<RankExplorer::Hop> RankExplorer::hopsTo(NodePlace place) {
  std::vector<Hop> hops;
  while (place.rank != kNone) {
    std::string own;
    if (place.rank == ranks.self())
      own = bytesOf([&](CheckpointWriter& to) { write(to, place.node); });
    auto from = readerOf(ranks.gather(own)[place.rank]);
    hops.push_back(readHop(from));
    place = hops.back().parent;
  }
  return hops;
}

void RankExplorer::write(CheckpointWriter& to, NodeIndex node) {
  const auto& zones = graph.timing.zones();
  const ZoneId zone = graph.zoneOf(node);
  std::vector<Word> state(system.storedWords);
  graph.states.read(graph.stateOf(node), state.data());
  for (const auto word : state) to.number(word);
  writeZone(to, zones.dimension(zone), zones.matrix(zone));
  to.number(graph.stepTo(node) + 1U);
  to.number(parentRanks.at(node));
  to.number(parents.at(node));
}

RankExplorer::Hop RankExplorer::readHop(CheckpointReader& from) const {
  Hop hop;
  for (std::uint32_t i = 0; i < system.storedWords; ++i) hop.state.push_back(from.number());
  hop.zone = readZone(from, static_cast<std::uint32_t>(system.clocks.size() + 1)).value();
  hop.step = static_cast<TransitionId>(from.number() - 1);
  hop.parent.rank = static_cast<std::uint32_t>(from.number() - 1);
  hop.parent.node = static_cast<NodeIndex>(from.number());
  return hop;
}

/// \param hops from the last node to the first
Steps RankExplorer::stepsAlong(const std::vector<Hop>& hops) {
  std::vector<PathNode> nodes;
  for (const auto& hop : hops)
    nodes.push_back({hop.state, signatureOf(hop.state), graph.timing.adopt(hop.zone), hop.step});
  std::ranges::reverse(nodes);
  Steps steps = pathSteps.toFirst();
  for (std::size_t i = 1; i < nodes.size(); ++i)
    append(steps, pathSteps.between(nodes[i - 1], nodes[i]));
  append(steps, pathSteps.atEnd(nodes.back().state));
  return steps;
}

RankExplorer::Reached RankExplorer::pathTo(NodePlace place) {
  const auto hops = hopsTo(place);
  Reached reached{{}, hops.front().state};
  if (ranks.self() == 0) reached.steps = stepsAlong(hops);
  return reached;
}

} // namespace proskill::verify
