#include "verify/explore/explorer.h"
#include "verify/reduce/free_inputs.h"
#include "verify/state/state_layout.h"

#include <algorithm>

namespace proskill::verify {

namespace {

void append(Steps& to, const Steps& more) { to.insert(to.end(), more.begin(), more.end()); }

} // namespace

Explorer::Walk Explorer::walkFrom(std::vector<Word> state) const {
  Walk walk{std::move(state), {}, {}};
  graph.enabling.compute(walk.state.data(), walk.enabled);
  return walk;
}

Explorer::Walk Explorer::walkFrom(StateId state) const {
  std::vector<Word> words(system.words);
  std::copy_n(graph.states.at(state), system.storedWords, words.begin());
  return walkFrom(std::move(words));
}

/// One step, with the setters that lead back to the values that stand for all.
bool Explorer::walkOn(Walk& walk, TransitionId transition) const {
  StepLog ignored;
  walk.taken.push_back(transition);
  const bool fired = fire(system, transition, walk.state.data(), ignored) == Outcome::Done;
  graph.enabling.update(transition, walk.state.data(), walk.enabled);
  if (reductions.freeInputs)
    append(walk.taken,
           reductions.freeInputs->normalise(walk.state.data(), walk.enabled, graph.enabling));
  return fired;
}

void Explorer::walkStubbornSets(Walk& walk) const {
  followStubbornSets(walk.state, walk.enabled,
                     [&](TransitionId next) { return walkOn(walk, next); });
}

/// To values of open variables with which time may pass, and back.
void Explorer::walkCalm(Walk& walk) const {
  const FreeInputs* open = reductions.freeInputs;
  if (!open || !graph.enabling.isUrgent(walk.enabled)) return;
  std::vector<Word> calm = walk.state;
  if (!open->calm(calm.data(), walk.enabled)) return;
  append(walk.taken, open->between(walk.state.data(), calm.data()));
  append(walk.taken, open->between(calm.data(), walk.state.data()));
}

/// The steps from a node's parent to it, or from the initial state.
const Steps& Explorer::legTo(NodeIndex index) const {
  if (const auto known = legs.find(index); known != legs.end()) return known->second;
  const ZoneNode& node = graph.nodes[index];
  const FreeInputs* open = reductions.freeInputs;
  Walk walk = node.parent == kNone ? walkFrom(initialState(system))
                                   : walkFrom(graph.nodes[node.parent].state);
  if (node.parent == kNone) {
    if (open) append(walk.taken, open->normalise(walk.state.data(), walk.enabled, graph.enabling));
  } else {
    walkCalm(walk);
    if (open) {
      const std::vector<Word> stored = walk.state;
      std::uint32_t choice = 0;
      open->eachFiring(node.transition, walk.state.data(), [&] { return choice++ == node.choice; });
      append(walk.taken, open->between(stored.data(), walk.state.data()));
      graph.enabling.compute(walk.state.data(), walk.enabled);
    }
    walkOn(walk, node.transition);
  }
  walkStubbornSets(walk);
  return legs.emplace(index, std::move(walk.taken)).first->second; // whole, or a limit was met
}

/// The way to a node, as it was taken: with the setters that lead to each choice of values and
/// back, and to one with which time may pass.
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
