#include "verify/explorer.h"

#include "verify/evaluate.h"
#include "verify/live_variables.h"
#include "verify/place.h"
#include "verify/safe_steps.h"

#include <algorithm>

namespace proskill::verify {

Explorer::Explorer(const System& of, const std::vector<Goal>& asked, const Reductions& with,
                   Forgetting forgetting, LimitWatch& watch)
    : system(of), goals(asked), reductions(with), limits(watch), graph(of, with, forgetting) {
  goalsOfEvent.resize(system.eventCount);
  result.goals.resize(goals.size());
  for (std::size_t i = 0; i < goals.size(); ++i) {
    const Goal& goal = goals[i];
    if (goal.kind == GoalKind::Unsupported) continue;
    ++open;
    goal.events.each([&](EventId event) { goalsOfEvent[event].push_back(i); });
    if (goal.kind != GoalKind::Condition) continue;
    stateGoals.push_back(i);
    if (goal.ofSteps) stepGoals.push_back(i);
  }
}

std::uint64_t ZoneGraph::bytes() const {
  return timing.bytes() + states.bytes() + signatureOf.capacity() * sizeof(SignatureId) +
         headOf.capacity() * sizeof(NodeIndex) + nodes.capacity() * sizeof(ZoneNode);
}

Progress Explorer::progress(NodeIndex next) const {
  return {graph.nodes.size(), graph.states.size(), graph.nodes.size() - next, graph.bytes(),
          limits.seconds()};
}

Explored Explorer::run() {
  start();
  constexpr NodeIndex kBetweenChecks = 256;
  NodeIndex next = 0;
  for (; next < graph.nodes.size() && result.failure.empty() && !allDecided(); ++next) {
    if (next % kBetweenChecks == 0) {
      result.statistics.stopped = limits.met(progress(next));
      if (!result.statistics.stopped.empty()) break;
    }
    if (!graph.nodes[next].covered) expand(next);
  }
  auto& statistics = result.statistics;
  statistics.complete = next == graph.nodes.size() && result.failure.empty();
  if (!statistics.complete && statistics.stopped.empty())
    statistics.stopped = result.failure.empty() ? "all questions decided" : "an error of the model";
  statistics.classes = graph.nodes.size();
  statistics.markings = graph.states.size();
  statistics.domains = graph.timing.zones().size();
  statistics.bytes = graph.bytes();
  statistics.seconds = limits.seconds();
  return std::move(result);
}

void Explorer::start() {
  Current current;
  current.state = initialState(system);
  graph.enabling.compute(current.state.data(), current.enabled);
  current.signature = graph.enabling.signature(current.enabled, graph.timing);
  current.zone = graph.timing.initial(current.signature);
  for (std::size_t i = 0; i < goals.size(); ++i)
    if (goals[i].kind == GoalKind::Events && goals[i].initially) found(i);
  noticeState(current);
  runSafeSteps(current);
  if (result.failure.empty()) add(current, kNone, kNone);
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
  passed.clear();
  bool stopped = true;
  eachIn(loaded.enabled, [&](TransitionId transition) {
    stopped = false;
    step(index, transition);
  });
  if (stopped) noticeDeadlock();
}

void Explorer::step(NodeIndex parent, TransitionId transition) {
  if (!result.failure.empty()) return;
  if (!graph.timing.isFirable(loaded.zone, loaded.signature, transition)) return;
  ++result.statistics.transitions;
  work.state = loaded.state;
  work.enabled = loaded.enabled;
  work.signature = loaded.signature;
  work.zone = loaded.zone;
  passed.clear();
  if (!advance(work, transition)) return;
  runSafeSteps(work);
  if (result.failure.empty()) add(work, parent, transition);
}

/// Fires a transition and notices what it shows. False where it cannot be fired after all.
bool Explorer::advance(Current& current, TransitionId transition) {
  log.clear();
  passed.push_back(transition);
  if (!stepGoals.empty()) before = current.state;
  const Outcome outcome = fire(system, transition, current.state.data(), log);
  if (outcome == Outcome::GaveUp) return false;
  if (outcome == Outcome::Failed) {
    result.failure = log.failure;
    result.failureOrigin = log.origins.empty() ? 0 : log.origins.back();
    return false;
  }
  graph.enabling.update(transition, current.state.data(), current.enabled);
  const SignatureId signature = graph.enabling.signature(current.enabled, graph.timing);
  current.zone = graph.timing.after(current.zone, current.signature, transition, signature);
  current.signature = signature;
  if (current.zone == kNone) return false;
  noticeStep(current);
  noticeState(current);
  return true;
}

/// As long as there is a step that is safe to take alone, takes it. Stops where it comes by a state
/// again: that state is then stored and expanded fully, so that nothing is put off for ever.
template <class Advance>
void Explorer::followSafeSteps(const std::vector<Word>& state, const TransitionSet& enabled,
                               Advance advance) const {
  if (!reductions.safeSteps) return;
  std::vector<Word> mark; // Brent: the state at the last power of two
  for (std::size_t length = 1;; ++length) {
    const TransitionId next = reductions.safeSteps->pick(state.data(), enabled);
    if (next == kNone || state == mark) return;
    if (std::has_single_bit(length)) mark = state;
    if (!advance(next)) return;
  }
}

void Explorer::runSafeSteps(Current& current) {
  followSafeSteps(current.state, current.enabled,
                  [&](TransitionId next) { return advance(current, next); });
}

Steps Explorer::pathTo(NodeIndex index) const {
  std::vector<NodeIndex> line;
  for (; index != kNone; index = graph.nodes[index].parent) line.push_back(index);
  Steps path;
  std::vector<Word> state = initialState(system);
  TransitionSet enabled;
  StepLog ignored;
  const auto fireOne = [&](TransitionId transition) {
    path.push_back(transition);
    bool fired = fire(system, transition, state.data(), ignored) == Outcome::Done;
    graph.enabling.update(transition, state.data(), enabled);
    return fired;
  };
  graph.enabling.compute(state.data(), enabled);
  followSafeSteps(state, enabled, fireOne);
  for (std::size_t i = line.size() - 1; i-- > 0;) {
    const Word* stored = graph.states.at(graph.nodes[line[i + 1]].state);
    state.assign(system.words, 0);
    std::copy(stored, stored + system.storedWords, state.begin());
    graph.enabling.compute(state.data(), enabled);
    fireOne(graph.nodes[line[i]].transition);
    followSafeSteps(state, enabled, fireOne);
  }
  return path;
}

void Explorer::add(Current& current, NodeIndex parent, TransitionId transition) {
  if (reductions.liveVariables) reductions.liveVariables->clean(current.state.data());
  const auto [state, isNew] = graph.states.add(current.state.data());
  if (isNew) {
    graph.signatureOf.push_back(current.signature);
    graph.headOf.push_back(kNone);
  } else if (isCovered(state, current.zone)) {
    return;
  }
  const auto index = static_cast<NodeIndex>(graph.nodes.size());
  graph.nodes.push_back({state, current.zone, parent, transition, graph.headOf[state]});
  graph.headOf[state] = index;
}

/// Whether a stored zone of the state includes the new one; those that the new one includes are
/// struck off.
bool Explorer::isCovered(StateId state, ZoneId zone) {
  const auto& zones = graph.timing.zones();
  for (NodeIndex i = graph.headOf[state]; i != kNone; i = graph.nodes[i].next) {
    if (graph.nodes[i].zone == zone) return true;
    if (reductions.inclusion && includes(zones.matrix(graph.nodes[i].zone), zones.matrix(zone)))
      return true;
  }
  if (!reductions.inclusion) return false;
  NodeIndex* link = &graph.headOf[state];
  while (*link != kNone) {
    ZoneNode& node = graph.nodes[*link];
    if (includes(zones.matrix(zone), zones.matrix(node.zone))) {
      node.covered = true;
      *link = node.next;
    } else {
      link = &node.next;
    }
  }
  return false;
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

void Explorer::found(std::size_t goal) {
  if (result.goals[goal]) return;
  --open;
  Steps& steps = result.goals[goal].emplace();
  if (expanding != kNone) steps = pathTo(expanding);
  steps.insert(steps.end(), passed.begin(), passed.end());
}

} // namespace proskill::verify
