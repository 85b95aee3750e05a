#include "verify/explore/explorer.h"

namespace proskill::verify {

PathNode Explorer::placeOf(NodeIndex node) const {
  const StateId state = graph.stateOf(node);
  PathNode place{std::vector<Word>(system.storedWords), graph.signatureOf(state),
                 graph.zoneOf(node), graph.stepTo(node)};
  graph.states.read(state, place.state.data());
  return place;
}

/// The steps from a node's parent to the node, or from the initial state.
const Steps& Explorer::legTo(NodeIndex index) const {
  if (const auto known = legs.find(index); known != legs.end()) return known->second;
  const NodeIndex parent = graph.parentOf(index);
  Steps leg =
      parent == kNone ? pathSteps.toFirst() : pathSteps.between(placeOf(parent), placeOf(index));
  return legs.emplace(index, std::move(leg)).first->second; // complete, or a limit was reached
}

/// The path to a node, including the setters that lead to each choice of values and back, and to
/// one with which time may pass.
Steps Explorer::pathTo(NodeIndex index) const {
  std::vector<NodeIndex> line;
  for (auto at = index; at != kNone; at = graph.parentOf(at)) line.push_back(at);
  Steps path;
  for (std::size_t i = line.size(); i-- > 0;) append(path, legTo(line[i]));
  append(path, pathSteps.atEnd(placeOf(index).state));
  return path;
}

} // namespace proskill::verify
