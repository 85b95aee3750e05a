#include "verify/explore/path_steps.h"

#include "verify/reduce/live_variables.h"

#include <algorithm>

namespace proskill::verify {

Steps PathSteps::toFirst() const {
  Walk walk = walker.fromStart();
  walker.runAlone(walk);
  return std::move(walk.taken);
}

Steps PathSteps::between(const PathNode& from, const PathNode& to) {
  const Successor& step = find(from, to);
  Walk walk = walkFrom(from.state);
  walkCalm(walk);
  walker.choose(walk, step.transition, step.choice);
  walker.take(walk, step.transition);
  walker.runAlone(walk);
  return std::move(walk.taken);
}

Steps PathSteps::atEnd(const std::vector<Word>& state) const {
  Walk walk = walkFrom(state);
  walkCalm(walk);
  return std::move(walk.taken);
}

/// Finds the step to a node by expanding the node before it again: the first successor that is the
/// node was added as the node. This takes little time if it is known which step it was.
const Successor& PathSteps::find(const PathNode& from, const PathNode& to) {
  expander.load(from.state.data(), from.signature, from.zone);
  expander.expand(again, to.step);
  return *std::ranges::find_if(again.successors, [&](const Successor& successor) {
    if (successor.zone != to.zone) return false;
    Word* const words = again.words.data() + successor.state;
    if (reductions.liveVariables && !std::equal(to.state.begin(), to.state.end(), words))
      reductions.liveVariables->clean(words);
    return std::equal(to.state.begin(), to.state.end(), words);
  });
}

Walk PathSteps::walkFrom(const std::vector<Word>& state) const {
  std::vector<Word> words = state;
  words.resize(system.words);
  return walker.from(std::move(words));
}

/// Sets open variables to values with which time may pass, and back.
void PathSteps::walkCalm(Walk& walk) const {
  const auto before = walker.becomeCalm(walk);
  walker.moveInputs(walk, before);
}

} // namespace proskill::verify
