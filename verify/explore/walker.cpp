#include "verify/explore/walker.h"

#include "verify/reduce/live_variables.h"
#include "verify/state/state_layout.h"

namespace proskill::verify {

void append(Steps& to, const Steps& more) { to.insert(to.end(), more.begin(), more.end()); }

Walk Walker::from(std::vector<Word> state) const {
  Walk walk{std::move(state), {}, {}};
  enabling.compute(walk.state.data(), walk.enabled);
  return walk;
}

Walk Walker::fromStart() const {
  Walk walk = from(initialState(system));
  normalise(walk);
  return walk;
}

void Walker::normalise(Walk& walk) const {
  if (reductions.freeInputs)
    append(walk.taken, reductions.freeInputs->normalise(walk.state.data(), walk.enabled, enabling));
}

bool Walker::take(Walk& walk, TransitionId transition) const {
  StepLog ignored;
  walk.taken.push_back(transition);
  const bool fired = fire(system, transition, walk.state.data(), ignored) == Outcome::Done;
  enabling.update(transition, walk.state.data(), walk.enabled);
  normalise(walk);
  return fired;
}

void Walker::choose(Walk& walk, TransitionId transition, std::uint32_t choice) const {
  if (!reductions.freeInputs) return;
  std::vector<Word> chosen = walk.state;
  std::uint32_t seen = 0;
  reductions.freeInputs->eachFiring(transition, chosen.data(), [&] { return seen++ == choice; });
  moveInputs(walk, chosen);
}

std::vector<Word> Walker::becomeCalm(Walk& walk) const {
  std::vector<Word> before = walk.state;
  if (!reductions.freeInputs || !enabling.isUrgent(walk.enabled)) return before;
  std::vector<Word> calm = walk.state;
  if (reductions.freeInputs->calm(calm.data(), walk.enabled)) moveInputs(walk, calm);
  return before;
}

void Walker::moveInputs(Walk& walk, const std::vector<Word>& to) const {
  if (!reductions.freeInputs || walk.state == to) return;
  append(walk.taken, reductions.freeInputs->between(walk.state.data(), to.data()));
  walk.state = to;
  enabling.compute(walk.state.data(), walk.enabled);
}

void Walker::runAlone(Walk& walk) const {
  followAlone(walk.state, walk.enabled, [&](TransitionId next) {
    choose(walk, next, 0);
    return take(walk, next);
  });
}

void Walker::arrive(Walk& walk) const {
  runAlone(walk);
  if (!reductions.liveVariables) return;
  reductions.liveVariables->clean(walk.state.data());
  enabling.compute(walk.state.data(), walk.enabled);
}

SignatureId Walker::signature(const std::vector<Word>& state, const TransitionSet& enabled,
                              Timing& timing) const {
  bool urgent = enabling.isUrgent(enabled);
  if (urgent && reductions.freeInputs) {
    trial = state;
    urgent = !reductions.freeInputs->calm(trial.data(), enabled);
  }
  return enabling.signature(enabled, urgent, timing);
}

} // namespace proskill::verify
