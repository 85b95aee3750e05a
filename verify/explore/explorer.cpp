#include "verify/explore/explorer.h"

#include "verify/explore/conclude.h"
#include "verify/reduce/live_variables.h"
#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <algorithm>

namespace proskill::verify {

Explorer::Explorer(const System& of, const std::vector<Goal>& asked, const Reductions& with,
                   Extrapolation extrapolation, LimitWatch& watch, OnFound tell, Pause until,
                   GoalDistance* distance)
    : system(of),
      goals(asked),
      reductions(with),
      limits(watch),
      onFound(std::move(tell)),
      pause(std::move(until)),
      graph(of, with, extrapolation),
      walker(of, graph.enabling, with),
      frontier(distance) {
  goalsOfEvent.resize(system.eventCount);
  hasErrors = std::ranges::any_of(system.transitions, &Transition::fails);
  result.goals.resize(goals.size());
  for (std::size_t i = 0; i < goals.size(); ++i) {
    const Goal& goal = goals[i];
    if (goal.kind == GoalKind::Unsupported || goal.kind == GoalKind::Run) continue;
    ++open;
    goal.events.each([&](EventId event) { goalsOfEvent[event].push_back(i); });
    if (goal.kind != GoalKind::Condition) continue;
    stateGoals.push_back(i);
    if (goal.ofSteps) stepGoals.push_back(i);
  }
}

std::uint64_t ZoneGraph::bytes() const {
  return timing.bytes() + states.bytes() + signatureOf.capacity() * sizeof(SignatureId) +
         (headOf.capacity() + coverOf.capacity()) * sizeof(NodeIndex) + coverBytes +
         nodes.capacity() * sizeof(ZoneNode);
}

std::uint64_t ZoneGraph::growth() const {
  return timing.growth() + states.growth() + growthOf(signatureOf) + growthOf(headOf) +
         growthOf(coverOf) + growthOf(nodes);
}

Progress Explorer::progress() const {
  return {graph.nodes.size(), graph.states.size(), frontier.left(), graph.bytes(),
          limits.seconds(),   goals.size() - open, goals.size()};
}

Explored Explorer::run() {
  auto& statistics = result.statistics;
  exploreWithinLimits(statistics, [this] { explore(); });
  conclude(statistics, frontier.left() == 0, result.failure, "all questions decided");
  statistics.classes = graph.nodes.size();
  statistics.markings = graph.states.size();
  statistics.domains = graph.timing.zones().size();
  statistics.bytes = graph.bytes();
  statistics.seconds = limits.seconds();
  return std::move(result);
}

/// \throw LimitMet
void Explorer::explore() {
  start();
  constexpr NodeIndex kBetweenChecks = 8;
  while (frontier.left() > 0 && result.failure.empty() && !allDecided()) {
    if (frontier.takenCount() % kBetweenChecks == 0)
      if (auto limit = limits.met(progress(), graph.growth()); !limit.empty())
        throw LimitMet{std::move(limit)};
    if (graph.nodes.size() >= pause.after) {
      pause.after = kNone;
      if (!pause.goesOn()) {
        result.paused = true;
        return;
      }
    }
    const NodeIndex next = frontier.take();
    if (!graph.nodes[next].covered) expand(next);
  }
}

void Explorer::start() {
  Current current;
  current.state = initialState(system);
  graph.enabling.compute(current.state.data(), current.enabled);
  for (std::size_t i = 0; i < goals.size(); ++i)
    if (goals[i].kind == GoalKind::Events && goals[i].initially) found(i);
  noticeState(current);
  if (reductions.freeInputs)
    passed =
        reductions.freeInputs->normalise(current.state.data(), current.enabled, graph.enabling);
  current.signature = walker.signature(current.state, current.enabled, graph.timing);
  current.zone = graph.timing.initial(current.signature);
  runAlone(current);
  if (result.failure.empty()) add(current, kNone, kNone, 0);
}

void Explorer::load(NodeIndex index) {
  const ZoneNode& node = graph.nodes[index];
  if (node.state != loadedState) {
    const Word* stored = graph.states.at(node.state);
    loaded.state.assign(system.words, 0);
    std::copy(stored, stored + system.storedWords, loaded.state.begin());
    graph.enabling.compute(loaded.state.data(), loaded.enabled);
    loaded.signature = graph.signatureOf[node.state];
    loadedState = node.state;
  }
  loaded.zone = node.zone;
}

void Explorer::expand(NodeIndex index) {
  load(index);
  expanding = index;
  frontier.expand(loaded.state.data());
  passed.clear();
  if (reductions.freeInputs) return expandOpen(index);
  bool stopped = true;
  const bool ends = fails(loaded.enabled); // a guard fails, which ends the run
  eachIn(loaded.enabled, [&](TransitionId transition) {
    stopped = false;
    if (ends && !system.transitions[transition].fails) return;
    if (!graph.enabling.isBlocked(transition, loaded.enabled)) step(index, transition);
  });
  if (stopped) noticeDeadlock();
}

/// The state represents all values of its open variables; each transition is fired once for each
/// choice of values that matters to it. There is no deadlock, since the environment can always
/// change its inputs.
void Explorer::expandOpen(NodeIndex index) {
  const FreeInputs& open = *reductions.freeInputs;
  std::vector<Word> state = loaded.state;
  const bool ends = fails(loaded.enabled);
  eachIn(open.candidates(state.data(), loaded.enabled), [&](TransitionId transition) {
    if (ends && !system.transitions[transition].fails) return;
    const bool within = open.staysWithin(transition, loaded.state.data());
    if (within && open.isSilent(transition)) return;
    std::uint32_t choice = 0;
    open.eachFiring(transition, state.data(), [&] {
      stepWith(index, transition, state, choice++);
      return false;
    });
  });
}

bool Explorer::fails(const TransitionSet& enabled) const {
  bool any = false;
  if (hasErrors)
    eachIn(enabled, [&](TransitionId id) { any = any || system.transitions[id].fails; });
  return any;
}

void Explorer::step(NodeIndex parent, TransitionId transition) {
  work = loaded;
  passed.clear();
  follow(parent, transition, 0);
}

/// Takes a step from the loaded state with other values of open variables.
void Explorer::stepWith(NodeIndex parent, TransitionId transition, const std::vector<Word>& state,
                        std::uint32_t choice) {
  const FreeInputs& open = *reductions.freeInputs;
  work = loaded;
  work.state = state;
  passed = open.between(loaded.state.data(), state.data());
  if (!passed.empty())
    for (auto variable : open.readBy(transition))
      graph.enabling.refresh(open.all()[variable].readers, work.state.data(), work.enabled);
  follow(parent, transition, choice);
}

void Explorer::follow(NodeIndex parent, TransitionId transition, std::uint32_t choice) {
  if (!result.failure.empty()) return;
  if (!graph.timing.isFirable(work.zone, work.signature, transition)) return;
  ++result.statistics.transitions;
  if (!advance(work, transition)) return;
  const FreeInputs* open = reductions.freeInputs;
  if (open && open->staysWithin(transition, loaded.state.data())) return;
  runAlone(work);
  if (result.failure.empty()) add(work, parent, transition, choice);
}

/// Fires a transition and records what it shows. \return false if it cannot be fired after all
bool Explorer::advance(Current& current, TransitionId transition) {
  limits.check();
  log.clear();
  passed.push_back(transition);
  if (!stepGoals.empty()) before = current.state;
  const Outcome outcome = fire(system, transition, current.state.data(), log);
  if (outcome == Outcome::GaveUp) return false;
  if (outcome == Outcome::Failed) {
    noticeError();
    return false;
  }
  graph.enabling.update(transition, current.state.data(), current.enabled);
  Steps back;
  if (reductions.freeInputs)
    back = reductions.freeInputs->normalise(current.state.data(), current.enabled, graph.enabling);
  const SignatureId signature = walker.signature(current.state, current.enabled, graph.timing);
  current.zone = graph.timing.after(current.zone, current.signature, transition, signature);
  current.signature = signature;
  if (current.zone == kNone) return false;
  noticeStep(current);
  noticeState(current);
  passed.insert(passed.end(), back.begin(), back.end());
  return true;
}

/// Sets open variables to the first choice of values with which the transition is fired.
void Explorer::chooseInputs(Current& current, TransitionId transition) {
  const FreeInputs* open = reductions.freeInputs;
  if (!open || open->readBy(transition).empty()) return;
  trial = current.state;
  open->eachFiring(transition, trial.data(), [] { return true; });
  append(passed, open->between(current.state.data(), trial.data()));
  current.state = trial;
  for (auto variable : open->readBy(transition))
    graph.enabling.refresh(open->all()[variable].readers, current.state.data(), current.enabled);
}

void Explorer::runAlone(Current& current) {
  walker.followAlone(current.state, current.enabled, [&](TransitionId next) {
    chooseInputs(current, next);
    return advance(current, next);
  });
}

void Explorer::add(Current& current, NodeIndex parent, TransitionId transition,
                   std::uint32_t choice) {
  if (reductions.liveVariables) reductions.liveVariables->clean(current.state.data());
  const auto [state, isNew] = graph.states.add(current.state.data());
  if (isNew) {
    graph.signatureOf.push_back(current.signature);
    graph.headOf.push_back(kNone);
    graph.coverOf.push_back(kNone);
  } else if (isCovered(state, current.zone)) {
    return;
  }
  const auto index = static_cast<NodeIndex>(graph.nodes.size());
  graph.nodes.push_back({state, current.zone, parent, transition, choice, graph.headOf[state]});
  graph.headOf[state] = index;
  frontier.add(current.state.data(), transition);
}

/// Whether stored zones of the state include the new one. Removes those that the new one includes.
bool Explorer::isCovered(StateId state, ZoneId zone) {
  const auto& zones = graph.timing.zones();
  if (graph.coverOf[state] != kNone) {
    ZoneCover& cover = graph.covers[graph.coverOf[state]];
    if (cover.includesZone(zones.matrix(zone))) return true;
    graph.coverBytes -= cover.bytes();
    cover.add(zones.zone(zone));
    graph.coverBytes += cover.bytes();
    return false;
  }
  for (NodeIndex i = graph.headOf[state]; i != kNone; i = graph.nodes[i].next) {
    if (graph.nodes[i].zone == zone) return true;
    if (reductions.inclusion && includes(zones.matrix(graph.nodes[i].zone), zones.matrix(zone)))
      return true;
  }
  if (reductions.inclusion) strike(state, zone);
  return false;
}

/// Removes the zones of the state that the new one includes. If many remain, replaces them by their
/// cover.
void Explorer::strike(StateId state, ZoneId zone) {
  constexpr std::size_t kMany = 16;
  const auto& zones = graph.timing.zones();
  std::size_t left = 0;
  NodeIndex* link = &graph.headOf[state];
  while (*link != kNone) {
    ZoneNode& node = graph.nodes[*link];
    if (includes(zones.matrix(zone), zones.matrix(node.zone))) {
      node.covered = true;
      *link = node.next;
    } else {
      link = &node.next;
      ++left;
    }
  }
  if (left < kMany) return;
  ZoneCover cover;
  for (NodeIndex i = graph.headOf[state]; i != kNone; i = graph.nodes[i].next)
    cover.add(zones.zone(graph.nodes[i].zone));
  cover.add(zones.zone(zone));
  graph.coverOf[state] = static_cast<std::uint32_t>(graph.covers.size());
  graph.coverBytes += cover.bytes();
  graph.covers.push_back(std::move(cover));
}

void Explorer::noticeStep(const Current& after) {
  for (auto event : log.events)
    for (auto goal : goalsOfEvent[event]) found(goal);
  if (stepGoals.empty()) return;
  Bits events;
  for (auto event : log.events) events.insert(event);
  const Moment moment{before.data(), after.state.data(), &events};
  for (auto goal : stepGoals)
    if (!result.goals[goal] && holdsAt(system, goals[goal].condition, moment)) found(goal);
}

void Explorer::noticeState(const Current& current) {
  const Moment moment{current.state.data(), nullptr, nullptr};
  for (auto goal : stateGoals)
    if (!result.goals[goal] && holdsAt(system, goals[goal].condition, moment)) found(goal);
}

void Explorer::noticeDeadlock() {
  const Moment moment{loaded.state.data(), nullptr, nullptr};
  for (std::size_t i = 0; i < goals.size(); ++i)
    if (goals[i].kind == GoalKind::Deadlock && !result.goals[i] &&
        !holdsAt(system, goals[i].condition, moment))
      found(i);
}

/// An error ends the exploration unless somebody asks for errors.
void Explorer::noticeError() {
  bool asked = false;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    if (goals[i].kind != GoalKind::Error) continue;
    asked = true;
    found(i);
  }
  if (asked) return;
  result.failure = log.failure;
  result.failureOrigin = log.origins.empty() ? 0 : log.origins.back();
}

void Explorer::found(std::size_t goal) {
  if (result.goals[goal]) return;
  --open;
  Steps& steps = result.goals[goal].emplace();
  if (expanding != kNone) steps = pathTo(expanding);
  steps.insert(steps.end(), passed.begin(), passed.end());
  if (onFound) onFound(goal, steps);
}

} // namespace proskill::verify
