#include "verify/trace/causes.h"

#include "verify/compile/watch.h"
#include "verify/model/nodes.h"
#include "verify/state/state_layout.h"
#include "verify/trace/clock_starts.h"

#include <algorithm>
#include <ranges>

namespace proskill::verify {

namespace {

/// What a step reads of the state before it, and what it writes.
class StepReads : public StepListener {
public:
  StepReads(const Footprints& with, LimitWatch& watch) : footprints(with), limits(watch) {}

  void beginApart() override { own = {}; }
  /// \throw LimitMet
  void evaluates(NodeId node, const Word* state, CellId target) override {
    limits.check();
    const auto needs =
        target == kNone ? footprints.of(node, state) : footprints.ofAssigned(node, state, target);
    for (auto cell : needs.before)
      if (!own.contains(cell)) read.insert(cell);
  }
  void writes(CellId cell) override {
    own.insert(cell);
    written.insert(cell);
  }

  Bits read;
  Bits written;

private:
  const Footprints& footprints;
  LimitWatch& limits;
  Bits own; ///< written by the current part: its value is the step's own
};

/// Numbers of steps, from 1. Ascending and without duplicates once all are found.
using StepNumbers = std::vector<std::size_t>;

void tidy(StepNumbers& numbers) {
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

class CauseFinder {
public:
  CauseFinder(const System& of, const Enabling& with, const fiacre::Provenance& origins,
              const Goal& sought, const Evidence& from, LimitWatch& watch)
      : system(of),
        enabling(with),
        provenance(origins),
        goal(sought),
        evidence(from),
        limits(watch),
        writers(of.cells.size()),
        footprints(of, writers),
        starts(of),
        causes(from.steps.size()) {
    made.grounds.resize(from.steps.size());
    made.timers.resize(from.steps.size());
    watchedAs.assign(of.cells.size(), kNone);
    for (std::uint32_t i = 0; i < of.watched.size(); ++i) watchedAs[of.watched[i].cell] = i;
    for (const auto& mark : from.marks)
      if (mark.until > mark.after) lateMarks.push_back(&mark);
  }

  Causes find() {
    state = initialState(system);
    enabling.compute(state.data(), enabled);
    const std::size_t count = evidence.steps.size();
    bool whole = goal.kind == GoalKind::Stuck || goal.kind == GoalKind::Lost ||
                 (evidence.monitor && !evidence.monitor->ofPoints);
    whole = !go(0, count, true) || whole;
    atEnd();
    if (evidence.loop) whole = !go(*evidence.loop, count, false) || whole;
    close(whole);
    return std::move(made);
  }

private:
  /// \return false if a step differs from the recorded one
  bool go(std::size_t first, std::size_t last, bool firstTime) {
    for (std::size_t i = first; i < last; ++i) {
      limits.check();
      if (!step(i, firstTime)) return false;
    }
    return true;
  }

  bool step(std::size_t i, bool firstTime) {
    const TransitionId id = evidence.steps[i];
    const Transition& transition = system.transitions[id];
    before = state;
    needBefore(i, transition);
    if (firstTime) wait(i, transition);
    StepReads reads(footprints, limits);
    log.clear();
    const auto outcome = fire(system, id, state.data(), log, reads);
    reads.read.each([&](CellId cell) { depend(causes[i], cell); });
    if (firstTime) explain(i, false);
    const bool fails = outcome == Outcome::Failed && i + 1 == evidence.steps.size();
    if (outcome != Outcome::Done && !fails) return false;
    if (fails) state = before;
    happened = {};
    for (auto event : log.events) happened.insert(event);
    if (evidence.monitor) watchStep(i);
    showLastStep(i);
    reads.written.each([&](CellId cell) {
      if (readCell(system, cell, before.data()) != readCell(system, cell, state.data()))
        writers[cell] = i + 1;
    });
    if (firstTime) explain(i, true);
    if (evidence.monitor) watchState(i + 1);
    if (fails) return true;
    const TransitionSet wereEnabled = enabled;
    enabling.update(id, state.data(), enabled);
    starts.restart(id, wereEnabled, enabled, i + 1);
    return true;
  }

  /// Adds what enabled the step: its guard, and those of transitions with priority.
  void needBefore(std::size_t i, const Transition& transition) {
    if (i == 0 && evidence.monitor) watchState(0);
    depend(causes[i], footprints.of(transition.guard, state.data()));
    for (auto blocker : transition.blockers) dependOnDisabled(causes[i], blocker);
    for (auto blocker : transition.laterBlockers) dependOnDisabled(causes[i], blocker);
    Bits watching;
    for (auto seen : transition.seen) addReads(system, seen, watching);
    watching.each([&](CellId cell) { depend(causes[i], cell); });
  }

  void wait(std::size_t i, const Transition& transition) {
    const bool waits = transition.interval.lower > 0 || transition.interval.lowerOpen;
    if (transition.clock == kNone || !waits) return;
    const std::size_t since = starts.of(transition.clock);
    if (since > 0) causes[i].push_back(since);
    made.timers[i] = Timer{since, transition.interval};
  }

  // --- Dependencies

  void depend(StepNumbers& on, CellId cell) const {
    if (writers[cell] != 0) on.push_back(writers[cell]);
  }
  void depend(StepNumbers& on, const Needs& needs) const {
    for (auto cell : needs.before) depend(on, cell);
  }

  /// Adds why the transition is not enabled in this state, or not yet.
  void dependOnDisabled(StepNumbers& on, TransitionId id) {
    const Transition& transition = system.transitions[id];
    if (!holds(system, transition.guard, state.data()))
      return depend(on, footprints.of(transition.guard, state.data()));
    transition.guardReads.each([&](CellId cell) { depend(on, cell); });
    if (transition.clock == kNone || !contains(enabled, id)) return;
    if (const auto since = starts.of(transition.clock); since > 0) on.push_back(since);
  }

  // --- Reads of the goal

  void atEnd() {
    const std::size_t last = evidence.steps.size();
    switch (goal.kind) {
    case GoalKind::Events:
    case GoalKind::Error:
      if (last > 0) seeds.push_back(last);
      break;
    case GoalKind::Condition: return showCondition();
    case GoalKind::Deadlock: return showDeadlock();
    case GoalKind::Run:
      if (evidence.rest) showDeadlock();
      break;
    case GoalKind::Stuck:
    case GoalKind::Lost:
    case GoalKind::Longest:
    case GoalKind::Shortest:
    case GoalKind::Unsupported: break;
    }
  }

  void showCondition() {
    const Moment still{state.data(), nullptr, nullptr};
    if (!holdsAt(system, goal.condition, still)) return; // shown by a step
    const auto needs = footprints.of(goal.condition, still);
    depend(seeds, needs);
    made.support = told(needs.before, state);
  }

  /// Adds what a condition on steps reads of the last step, as `watchStep` does.
  void showLastStep(std::size_t i) {
    if (goal.kind != GoalKind::Condition || i + 1 != evidence.steps.size()) return;
    if (holdsAt(system, goal.condition, {state.data(), nullptr, nullptr})) return;
    seeds.push_back(i + 1);
    readStep(i, goal.condition);
  }

  void showDeadlock() {
    for (TransitionId id = 0; id < system.transitions.size(); ++id) {
      limits.check();
      dependOnDisabled(seeds, id);
    }
    depend(seeds, footprints.of(goal.condition, state.data()));
  }

  /// Adds what the monitor reads of the state after this many steps: whether it may stay, and may
  /// move.
  void watchState(std::size_t taken) {
    const auto& marks = evidence.marks;
    const auto& locations = evidence.monitor->locations;
    const auto needsState = [&](NodeId node) { depend(seeds, footprints.of(node, state.data())); };
    auto mark = firstBehind(taken);
    for (; mark != marks.end() && mark->after == taken; ++mark) {
      needsState(locations[mark->location].stay);
      if (!mark->ticks) needsState(conditionOf(*mark)); // a tick reads nothing
    }
    for (const auto* late : lateMarks)
      if (late->after < taken && taken <= late->until && !late->ticks)
        needsState(conditionOf(*late));
    if (mark != marks.end())
      needsState(locations[mark->location].stay);
    else if (!marks.empty())
      needsState(locations[locationAfter(marks.back())].stay);
  }

  /// The first move after this many steps.
  [[nodiscard]] std::vector<MonitorMove>::const_iterator firstBehind(std::size_t taken) const {
    return std::ranges::partition_point(evidence.marks, [&](const MonitorMove& mark) {
      return mark.after < taken || (mark.atStep && mark.after == taken);
    });
  }

  void watchStep(std::size_t i) {
    const auto mark = firstBehind(i + 1);
    if (mark == evidence.marks.begin() || !std::prev(mark)->atStep) return;
    if (std::prev(mark)->after == i + 1) readStep(i, conditionOf(*std::prev(mark)));
  }

  /// Adds what a condition reads of a step, before the step counts as the writer of its changes.
  void readStep(std::size_t i, NodeId condition) {
    const auto needs = footprints.of(condition, {before.data(), state.data(), &happened});
    depend(seeds, needs);
    for (auto cell : needs.after) {
      depend(seeds, cell);
      if (readCell(system, cell, before.data()) != readCell(system, cell, state.data()))
        seeds.push_back(i + 1);
    }
    if (needs.event) seeds.push_back(i + 1);
  }

  [[nodiscard]] std::uint32_t locationAfter(const MonitorMove& mark) const {
    return mark.ticks ? mark.location : edgeOf(mark).to;
  }

  [[nodiscard]] const MonitorEdge& edgeOf(const MonitorMove& mark) const {
    return evidence.monitor->locations[mark.location].edges[mark.edge];
  }
  [[nodiscard]] NodeId conditionOf(const MonitorMove& mark) const { return edgeOf(mark).condition; }

  // --- Descriptions

  void explain(std::size_t i, bool afterwards) {
    const auto& at = afterwards ? state : before;
    for (auto origin : log.origins) {
      const auto [first, last] =
          std::ranges::equal_range(system.grounds, origin, {}, &GroundNode::origin);
      for (const auto& ground : std::ranges::subrange(first, last)) {
        const auto& told = provenance.origins[origin].grounds[ground.index];
        if (told.afterwards == afterwards && !told.isOfWaits()) explain(i, ground, at);
      }
    }
  }

  void explain(std::size_t i, const GroundNode& ground, const std::vector<Word>& at) {
    FaultId fault = kNoFault;
    const auto value = evaluate(system, ground.node, at.data(), fault);
    if (fault != kNoFault) return;
    auto& all = made.grounds[i];
    const auto same = [&](const GroundValue& it) {
      return it.origin == ground.origin && it.ground == ground.index;
    };
    if (std::ranges::any_of(all, same)) return;
    all.push_back({ground.origin, ground.index, value,
                   told(footprints.of(ground.node, at.data()).before, at)});
  }

  [[nodiscard]] std::vector<Support> told(const std::vector<CellId>& cells,
                                          const std::vector<Word>& at) const {
    std::vector<Support> all;
    for (auto cell : cells) {
      Support made{{}, {}, writers[cell]};
      if (watchedAs[cell] != kNone) {
        const auto& watched = system.watched[watchedAs[cell]];
        made.variable = watched.display;
        made.value = shown(watched, readCell(system, cell, at.data()));
      }
      if (std::ranges::find(all, made) == all.end()) all.push_back(std::move(made));
    }
    return all;
  }

  /// Adds relevant steps, and all that they depend on.
  void close(bool whole) {
    const std::size_t count = evidence.steps.size();
    made.relevant.assign(count, whole);
    std::ranges::for_each(causes, tidy);
    std::vector<std::size_t> todo = std::move(seeds);
    while (!todo.empty()) {
      const std::size_t taken = todo.back();
      todo.pop_back();
      if (made.relevant[taken - 1] && !whole) continue;
      made.relevant[taken - 1] = true;
      if (!whole) todo.insert(todo.end(), causes[taken - 1].begin(), causes[taken - 1].end());
    }
    for (const auto& each : causes) {
      auto& all = made.of.emplace_back();
      for (auto taken : each) all.push_back(taken - 1);
    }
  }

  const System& system;
  const Enabling& enabling;
  const fiacre::Provenance& provenance;
  const Goal& goal;
  const Evidence& evidence;
  LimitWatch& limits;
  std::vector<std::size_t> writers; ///< by cell: the number of the last step that wrote it
  Footprints footprints;
  ClockStarts starts;
  std::vector<StepNumbers> causes; ///< by step
  StepNumbers seeds;               ///< the dependencies of the goal
  Causes made;
  std::vector<std::uint32_t> watchedAs;      ///< by cell
  std::vector<const MonitorMove*> lateMarks; ///< moves that may also follow later steps
  std::vector<Word> before;
  std::vector<Word> state;
  TransitionSet enabled;
  Bits happened; ///< in the last step
  StepLog log;
};

bool isFree(const System& system, TransitionId id, const std::vector<Word>& state) {
  const auto enabled = [&](TransitionId other) { return isEnabled(system, other, state.data()); };
  return enabled(id) && std::ranges::none_of(system.transitions[id].blockers, enabled);
}

} // namespace

Causes causesOf(const System& system, const Enabling& enabling,
                const fiacre::Provenance& provenance, const Goal& goal, const Evidence& evidence,
                LimitWatch& limits) {
  return CauseFinder(system, enabling, provenance, goal, evidence, limits).find();
}

bool reproduces(const System& system, const Goal& goal, const Evidence& evidence,
                const std::vector<bool>& relevant) {
  std::vector<Word> state = initialState(system);
  std::vector<Word> before = state;
  StepLog log;
  Bits events;
  bool fails = false;
  for (std::size_t i = 0; i < evidence.steps.size(); ++i) {
    if (!relevant[i]) continue;
    if (fails || !isFree(system, evidence.steps[i], state)) return false;
    before = state;
    log.clear();
    const auto outcome = fire(system, evidence.steps[i], state.data(), log);
    fails = outcome == Outcome::Failed;
    if (!fails && outcome != Outcome::Done) return false;
    events = {};
    for (auto event : log.events) events.insert(event);
  }
  switch (goal.kind) {
  case GoalKind::Error: return fails;
  case GoalKind::Events: return goal.initially || events.meets(goal.events);
  case GoalKind::Condition:
    return holdsAt(system, goal.condition, {state.data(), nullptr, nullptr}) ||
           holdsAt(system, goal.condition, {before.data(), state.data(), &events});
  case GoalKind::Deadlock: {
    for (TransitionId id = 0; id < system.transitions.size(); ++id)
      if (isEnabled(system, id, state.data())) return false;
    return !holdsAt(system, goal.condition, {state.data(), nullptr, nullptr});
  }
  case GoalKind::Stuck:
  case GoalKind::Run:
  case GoalKind::Lost:
  case GoalKind::Longest:
  case GoalKind::Shortest:
  case GoalKind::Unsupported: return true;
  }
  return false;
}

} // namespace proskill::verify
