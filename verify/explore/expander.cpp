#include "verify/explore/expander.h"

#include "verify/reduce/live_variables.h"
#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <algorithm>

namespace proskill::verify {

void Expansion::clear() {
  successors.clear();
  words.clear();
  steps.clear();
  notices.clear();
  transitions = 0;
  failure.clear();
}

Expander::Expander(const System& of, const OpenGoals& asked, const Reductions& with,
                   const ZoneGraph& in, Timing& when, LimitWatch& watch)
    : system(of),
      goals(asked),
      reductions(with),
      graph(in),
      enabling(in.enabling),
      timing(when),
      limits(watch),
      walker(of, in.enabling, with),
      constantSteps(of),
      looksAhead(!of.clocks.empty() || !isEmpty(in.enabling.urgentOnes()) || with.freeInputs ||
                 with.stubbornSets || with.privateMoves) {
  timing.callBetween([&zones = timing, &watch] { watch.checkGrowth(zones.growth()); });
  goalsOfEvent.resize(system.eventCount);
  hasErrors = std::ranges::any_of(system.transitions, &Transition::fails);
  for (std::size_t i = 0; i < goals.goals.size(); ++i) {
    const Goal& goal = goals.goals[i];
    if (goal.kind == GoalKind::Unsupported || goal.kind == GoalKind::Run) continue;
    goal.events.each([&](EventId event) { goalsOfEvent[event].push_back(i); });
    if (goal.kind != GoalKind::Condition) continue;
    stateGoals.push_back(i);
    if (goal.ofSteps) stepGoals.push_back(i);
  }
}

void Expander::start(Expansion& to) {
  made = &to;
  to.clear();
  noticed = {};
  passed.clear();
  work.state = initialState(system);
  enabling.compute(work.state.data(), work.enabled);
  for (std::size_t i = 0; i < goals.goals.size(); ++i)
    if (goals.goals[i].kind == GoalKind::Events && goals.goals[i].initially) notice(i);
  noticeState();
  if (reductions.freeInputs)
    passed = reductions.freeInputs->normalise(work.state.data(), work.enabled, enabling);
  work.signature = walker.signature(work.state, work.enabled, timing);
  work.zone = timing.initial(work.signature);
  runAlone();
  if (to.failure.empty()) add(kNone, 0);
}

/// Removes goals that were found, so that they cost nothing any more.
void Expander::forgetClosedGoals() {
  const auto isFound = [this](std::size_t goal) { return goals.found[goal]; };
  for (auto& some : goalsOfEvent) std::erase_if(some, isFound);
  std::erase_if(stateGoals, isFound);
  std::erase_if(stepGoals, isFound);
  forgotten = goals.closed;
}

void Expander::load(const Word* stored, SignatureId signature, ZoneId zone) {
  if (goals.closed > forgotten + forgotten / 4) forgetClosedGoals();
  loaded.zone = zone;
  if (!loaded.state.empty() &&
      std::equal(stored, stored + system.storedWords, loaded.state.begin()))
    return;
  loaded.state.assign(system.words, 0);
  std::copy(stored, stored + system.storedWords, loaded.state.begin());
  enabling.compute(loaded.state.data(), loaded.enabled);
  loaded.signature = signature;
}

void Expander::expand(Expansion& to, TransitionId only) {
  made = &to;
  onlyStep = only;
  to.clear();
  if (!noticed.empty()) noticed = {};
  passed.clear();
  if (reductions.freeInputs) return expandOpen();
  bool stopped = true;
  const bool ends = fails(loaded.enabled); // a guard fails, which ends the run
  eachIn(loaded.enabled, [&](TransitionId transition) {
    stopped = false;
    if (ends && !system.transitions[transition].fails) return;
    if (!enabling.isBlocked(transition, loaded.enabled)) step(transition);
  });
  if (stopped) noticeDeadlock();
}

/// The state represents all values of its open variables; each transition is fired once for each
/// choice of values that matters to it. There is no deadlock, since the environment can always
/// change its inputs.
void Expander::expandOpen() {
  const FreeInputs& open = *reductions.freeInputs;
  std::vector<Word> state = loaded.state;
  const bool ends = fails(loaded.enabled);
  eachIn(open.candidates(state.data(), loaded.enabled), [&](TransitionId transition) {
    if (ends && !system.transitions[transition].fails) return;
    const bool within = open.staysWithin(transition, loaded.state.data());
    if (within && open.isSilent(transition)) return;
    std::uint32_t choice = 0;
    open.eachFiring(transition, state.data(), [&] {
      stepWith(transition, state, choice++);
      return false;
    });
  });
}

bool Expander::fails(const TransitionSet& enabled) const {
  bool any = false;
  if (hasErrors)
    eachIn(enabled, [&](TransitionId id) { any = any || system.transitions[id].fails; });
  return any;
}

void Expander::step(TransitionId transition) {
  if (!isTaken(transition)) return;
  if (!timing.isFirable(loaded.zone, loaded.signature, transition)) return;
  beginStep();
  passed.clear();
  follow(transition, 0);
}

void Expander::beginStep() {
  if (looksAhead) {
    work = loaded;
    return;
  }
  work.state = loaded.state;
  work.signature = loaded.signature;
  work.zone = loaded.zone;
}

/// Takes a step from the loaded state with other values of open variables.
void Expander::stepWith(TransitionId transition, const std::vector<Word>& state,
                        std::uint32_t choice) {
  if (!isTaken(transition)) return;
  if (!timing.isFirable(loaded.zone, loaded.signature, transition)) return;
  const FreeInputs& open = *reductions.freeInputs;
  work = loaded;
  work.state = state;
  passed = open.between(loaded.state.data(), state.data());
  if (!passed.empty())
    for (auto variable : open.readBy(transition))
      enabling.refresh(open.all()[variable].readers, work.state.data(), work.enabled);
  follow(transition, choice);
}

void Expander::follow(TransitionId transition, std::uint32_t choice) {
  ++made->transitions;
  if (!advance(transition)) return;
  const FreeInputs* open = reductions.freeInputs;
  if (open && open->staysWithin(transition, loaded.state.data())) return;
  runAlone();
  if (made->failure.empty()) add(transition, choice);
}

/// Fires a transition and records what it shows. \return false if it cannot be fired after all
bool Expander::advance(TransitionId transition) {
  limits.check();
  log.clear();
  passed.push_back(transition);
  if (!stepGoals.empty()) before = work.state;
  const Outcome outcome = fire(transition);
  if (outcome == Outcome::GaveUp) return false;
  if (outcome == Outcome::Failed) {
    noticeError();
    return false;
  }
  Steps back;
  if (looksAhead && !enter(transition, back)) return false;
  noticeStep();
  noticeState();
  append(passed, back);
  return true;
}

Outcome Expander::fire(TransitionId transition) {
  if (!constantSteps.contain(transition))
    return verify::fire(system, transition, work.state.data(), log);
  constantSteps.fire(transition, work.state.data());
  return Outcome::Done;
}

/// Computes what is possible in the state after a step, and its zone.
/// \param back steps that give open variables their representative values
/// \return whether there is such a zone
bool Expander::enter(TransitionId transition, Steps& back) {
  enabling.update(transition, work.state.data(), work.enabled);
  if (reductions.freeInputs)
    back = reductions.freeInputs->normalise(work.state.data(), work.enabled, enabling);
  const SignatureId signature = walker.signature(work.state, work.enabled, timing);
  work.zone = timing.after(work.zone, work.signature, transition, signature);
  work.signature = signature;
  return work.zone != kNone;
}

/// Sets open variables to the first choice of values with which the transition is fired.
void Expander::chooseInputs(TransitionId transition) {
  const FreeInputs* open = reductions.freeInputs;
  if (!open || open->readBy(transition).empty()) return;
  trial = work.state;
  open->eachFiring(transition, trial.data(), [] { return true; });
  append(passed, open->between(work.state.data(), trial.data()));
  work.state = trial;
  for (auto variable : open->readBy(transition))
    enabling.refresh(open->all()[variable].readers, work.state.data(), work.enabled);
}

void Expander::runAlone() {
  walker.followAlone(work.state, work.enabled, [&](TransitionId next) {
    chooseInputs(next);
    return advance(next);
  });
}

void Expander::add(TransitionId transition, std::uint32_t choice) {
  const auto firstStep = made->steps.size();
  if (made->keepsSteps) append(made->steps, passed);
  made->successors.push_back({made->words.size(), firstStep, made->steps.size(), work.signature,
                              work.zone, transition, choice});
  made->words.insert(made->words.end(), work.state.begin(), work.state.end());
}

/// The table of states does not fit into the caches of the processor, so the entries of all
/// successors are loaded before the first is used.
void Expander::prefetchStates(const Expansion& of, const StateTree::Path& near) {
  const RootTable& table = graph.states.roots;
  const auto& roots = graph.states.findRoots(of.words, system.words, near, group);
  for (const auto& root : roots)
    if (root) table.prefetchSlot(*root);
  for (const auto& root : roots)
    if (root) table.prefetchState(*root);
}

void Expander::reduce(Expansion& to, const StateTree::Path& near, Claimer* claimer) {
  prefetchStates(to, near);
  std::size_t left = 0;
  for (std::size_t i = 0; i < to.successors.size(); ++i) {
    Successor it = to.successors[i];
    auto& root = group.roots[i];
    if (reductions.liveVariables) {
      if (root) it.known = graph.states.roots.find(*root);
      Word* const words = to.words.data() + it.state;
      if (it.known == kNone) reductions.liveVariables->clean(words);
      if (it.known == kNone) root = graph.states.findRoot(words, path);
    }
    const bool isLeft = it.known != kNone || !root || lookUp(it, *root, claimer);
    if (isLeft && !isCovered(it)) to.successors[left++] = it;
  }
  to.successors.resize(left);
}

/// Looks for a state, or claims it. \return whether the successor may add to the graph: without
/// time it does not if the same state follows before it, in the order of the nodes and steps
bool Expander::lookUp(Successor& successor, const SoughtRoot& root, Claimer* claimer) const {
  if (!claimer) {
    successor.known = graph.states.roots.find(root);
    return true;
  }
  const auto found = claimer->table.findOrClaim(root, claimer->node, claimer->own);
  successor.known = found.id;
  successor.claim = found.claim;
  const bool isBefore = found.claim != kNone && !found.isNew && found.claimant <= claimer->node;
  return !isBefore || !system.clocks.empty();
}

bool Expander::isCovered(const Successor& successor) const {
  if (successor.known == RootTable::kStored) return true; // covers() would say so, but later
  return successor.known != kNone &&
         graph.covers(successor.known, timing.zones().matrix(successor.zone), reductions.inclusion);
}

void Expander::noticeStep() {
  for (auto event : log.events)
    for (auto goal : goalsOfEvent[event]) notice(goal);
  if (stepGoals.empty()) return;
  Bits events;
  for (auto event : log.events) events.insert(event);
  const Moment moment{before.data(), work.state.data(), &events};
  for (auto goal : stepGoals)
    if (isOpen(goal) && holdsAt(system, goals.goals[goal].condition, moment)) notice(goal);
}

void Expander::noticeState() {
  const Moment moment{work.state.data(), nullptr, nullptr};
  for (auto goal : stateGoals)
    if (isOpen(goal) && holdsAt(system, goals.goals[goal].condition, moment)) notice(goal);
}

void Expander::noticeDeadlock() {
  const Moment moment{loaded.state.data(), nullptr, nullptr};
  for (std::size_t i = 0; i < goals.goals.size(); ++i)
    if (goals.goals[i].kind == GoalKind::Deadlock && isOpen(i) &&
        !holdsAt(system, goals.goals[i].condition, moment))
      notice(i);
}

/// An error ends the exploration unless somebody asks for errors.
void Expander::noticeError() {
  bool asked = false;
  for (std::size_t i = 0; i < goals.goals.size(); ++i) {
    if (goals.goals[i].kind != GoalKind::Error) continue;
    asked = true;
    notice(i);
  }
  if (asked) return;
  made->failure = log.failure;
  made->failureOrigin = log.origins.empty() ? 0 : log.origins.back();
}

void Expander::notice(std::size_t goal) {
  if (!isOpen(goal)) return;
  noticed.insert(static_cast<std::uint32_t>(goal));
  made->notices.push_back({goal, passed});
}

} // namespace proskill::verify
