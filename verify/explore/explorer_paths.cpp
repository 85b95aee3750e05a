#include "verify/explore/explorer.h"

#include <algorithm>

namespace proskill::verify {

Walk Explorer::walkFrom(StateId state) const {
  std::vector<Word> words(system.words);
  std::copy_n(graph.states.at(state), system.storedWords, words.begin());
  return walker.from(std::move(words));
}

/// Sets open variables to values with which time may pass, and back.
void Explorer::walkCalm(Walk& walk) const {
  const auto before = walker.becomeCalm(walk);
  walker.moveInputs(walk, before);
}

/// The steps from a node's parent to the node, or from the initial state.
const Steps& Explorer::legTo(NodeIndex index) const {
  if (const auto known = legs.find(index); known != legs.end()) return known->second;
  const ZoneNode& node = graph.nodes[index];
  Walk walk = node.parent == kNone ? walker.fromStart() : walkFrom(graph.nodes[node.parent].state);
  if (node.parent != kNone) {
    walkCalm(walk);
    walker.choose(walk, node.transition, node.choice);
    walker.take(walk, node.transition);
  }
  walker.runAlone(walk);
  return legs.emplace(index, std::move(walk.taken)).first->second; // complete, or a limit was
                                                                   // reached
}

/// The path to a node, including the setters that lead to each choice of values and back, and to
/// one with which time may pass.
Steps Explorer::pathTo(NodeIndex index) const {
  std::vector<NodeIndex> line;
  for (auto at = index; at != kNone; at = graph.nodes[at].parent) line.push_back(at);
  Steps path;
  for (std::size_t i = line.size(); i-- > 0;) append(path, legTo(line[i]));
  Walk end = walkFrom(graph.nodes[index].state);
  walkCalm(end);
  append(path, end.taken);
  return path;
}

} // namespace proskill::verify
