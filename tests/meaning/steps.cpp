#include "tests/meaning/steps.h"

#include "tests/meaning/endings.h"
#include "tests/meaning/step.h"

#include <algorithm>

namespace proskill::meaning {
namespace {

using syntax::Statement;
using syntax::StatementKind;

bool isWait(StatementKind kind) {
  return kind == StatementKind::WaitCondition || kind == StatementKind::WaitTime;
}

/// Everything that can happen in one situation.
class Steps {
public:
  Steps(const Script& of, const Situation& at) : script(of), now(at), look(of, at) {}

  std::vector<Step> find() {
    for (int skill = 0; skill < static_cast<int>(script.skills.size()); ++skill) ofSkill(skill);
    for (int thread = 0; thread < static_cast<int>(script.threads.size()); ++thread)
      ofThread(thread);
    if (script.environment == kNobody) ofTheWorld();
    ofTheEnd();
    return std::move(all);
  }

private:
  [[nodiscard]] Change change(When when = When::now()) const { return {script, now, when}; }
  void add(Change made) { all.push_back(made.take()); }

  // --- Skills

  void ofSkill(int skill) {
    const auto& state = now.skills[skill];
    if (script.skills[skill].calledByAnyone && state.phase == Phase::Idle) {
      auto called = change(When::anyTime());
      called.call(skill, kRoot);
      add(std::move(called));
    }
    if (state.phase == Phase::Called) ofCalled(skill);
    if (state.phase == Phase::Running && !script.skills[skill].isComposite()) ofRunning(skill);
  }

  void ofCalled(int skill) {
    if (now.skills[skill].stop) {
      auto stopped = change();
      stopped.stopBeforeStart(skill);
      return add(std::move(stopped));
    }
    if (look.someGuardFails() || !resourcesAreFree(skill)) return;
    auto begun = change();
    if (look.preconditionHolds(skill))
      begun.startSkill(skill);
    else
      begun.refuse(skill);
    add(std::move(begun));
  }

  [[nodiscard]] bool resourcesAreFree(int skill) const {
    return std::ranges::all_of(script.skills[skill].node->resources, [&](const auto& name) {
      for (std::size_t i = 0; i < script.resources.size(); ++i) {
        const auto& resource = *script.resources[i];
        const auto capacity = resource.capacity ? resource.capacity->number.numerator : 1;
        if (resource.name.text == name.text) return now.used[i] < capacity;
      }
      return false;
    });
  }

  void ofRunning(int skill) {
    const auto& node = *script.skills[skill].node;
    const int clock = static_cast<int>(script.threads.size()) + skill;
    const auto when = node.timeInterval ? within(*node.timeInterval, clock) : When::anyTime();
    for (const auto& ending : outcomesOf(node)) end(skill, ending, when);
    if (now.skills[skill].stop) end(skill, interruptionOf(node), When::now());
    for (const auto& invariant : node.invariants)
      if (!look.holds(invariant.guard)) end(skill, failureOf(invariant), When::now());
  }

  void end(int skill, const Ending& ending, When when) {
    auto ended = change(when);
    ended.endSkill(skill, ending);
    add(std::move(ended));
  }

  [[nodiscard]] When within(const syntax::Interval& seconds, int clock) const {
    When when{.clock = clock, .lower = script.units(seconds.lower)};
    when.lowerOpen = seconds.lowerOpen;
    if (!seconds.upper) return when;
    when.upper = script.units(*seconds.upper);
    when.upperOpen = seconds.upperOpen;
    return when;
  }

  // --- Threads

  void ofThread(int thread) {
    const auto& state = now.threads[thread];
    const auto& place = script.threads[thread].places[state.place];
    switch (state.control) {
    case Control::Off: return;
    case Control::Called: return ofCalledBranch(thread);
    case Control::Stopping: return ofStopping(thread);
    case Control::Before:
    case Control::Busy:
    case Control::Within: break;
    }
    if (mayGoOn(thread) || waitsForTime(thread)) {
      if (state.control == Control::Before)
        ofStatement(thread, place);
      else if (state.control == Control::Busy)
        ofBusy(thread, place);
      else if (place.statement->kind == StatementKind::Call)
        ofCall(thread, place);
      else
        ofJoin(thread, place);
    }
    if (isWaiting(thread)) ofStop(thread);
    ofGuards(thread);
  }

  /// Time goes on whatever the guards say.
  [[nodiscard]] bool waitsForTime(int thread) const { return now.ages[thread].counts; }

  /// A body whose guard is false does nothing more.
  [[nodiscard]] bool mayGoOn(int thread) const {
    const int skill = script.threads[thread].skill;
    return skill == kNobody || look.guardsHold(skill);
  }

  /// Control stands where time can pass.
  [[nodiscard]] bool isWaiting(int thread) const {
    const auto& state = now.threads[thread];
    if (state.control == Control::Busy || state.control == Control::Within) return true;
    const auto* statement = script.threads[thread].places[state.place].statement;
    return state.control == Control::Before && statement && isWait(statement->kind);
  }

  void ofCalledBranch(int thread) {
    auto made = change();
    if (now.threads[thread].stop)
      made.endBranch(thread);
    else
      made.goTo(thread, script.threads[thread].entry);
    add(std::move(made));
  }

  /// Nothing that it called is left running.
  void ofStopping(int thread) {
    const auto& state = now.threads[thread];
    const auto& of = script.threads[thread];
    const auto& place = of.places[state.place];
    auto made = change();
    if (state.waits) {
      for (const int branch : place.branches)
        if (now.threads[branch].control != Control::Off) return;
      if (place.branches.empty()) {
        const int callee = script.skill(place.statement->head.text);
        if (isOutstanding(callee, thread)) return;
        if (now.skills[callee].caller == thread) {
          made.after().skills[callee].phase = Phase::Idle;
          made.after().skills[callee].caller = kNobody;
        }
      }
    }
    if (of.isBranch())
      made.endBranch(thread);
    else
      made.endSkill(of.skill, state.ending);
    add(std::move(made));
  }

  [[nodiscard]] bool isOutstanding(int callee, int thread) const {
    const auto& state = now.skills[callee];
    return state.caller == thread && state.phase != Phase::Returned;
  }

  void strike(int thread, const Ending& ending) {
    auto struck = change();
    struck.strike(thread, ending);
    add(std::move(struck));
  }

  void ofStop(int thread) {
    const auto& of = script.threads[thread];
    if (of.skill == kNobody) return;
    if (of.isBranch()) {
      if (now.threads[thread].stop) strike(thread, {});
      return;
    }
    if (now.skills[of.skill].stop) strike(thread, interruptionOf(*script.skills[of.skill].node));
    const bool joining = now.threads[thread].control == Control::Within &&
                         !of.places[now.threads[thread].place].branches.empty();
    if (joining && now.decided[of.skill]) strike(thread, *now.decided[of.skill]);
  }

  void ofGuards(int thread) {
    const auto& of = script.threads[thread];
    if (of.skill == kNobody) return;
    const auto& node = *script.skills[of.skill].node;
    if (of.isBranch()) {
      if (!look.guardsHold(of.skill) && !isWaiting(thread) && now.threads[thread].stop)
        strike(thread, {});
      return;
    }
    for (const auto& invariant : node.invariants)
      if (!look.holds(invariant.guard)) strike(thread, failureOf(invariant));
  }

  // --- Statements

  void ofStatement(int thread, const Place& place) {
    if (!place.statement) return ofBodyEnd(thread);
    const auto& statement = *place.statement;
    switch (statement.kind) {
    case StatementKind::Call: return ofNewCall(thread, place);
    case StatementKind::Interrupt: return ofInterrupt(thread, place);
    case StatementKind::WaitCondition:
      if (look.holds(statement.condition, thread)) go(thread, place.next, &statement.effects);
      return;
    case StatementKind::WaitTime:
      return go(thread, place.next, nullptr, within(statement.duration, thread));
    case StatementKind::If: return go(thread, armOf(thread, place));
    case StatementKind::While:
      return go(thread, look.holds(statement.condition, thread) ? place.targets[0] : place.next);
    case StatementKind::DoUntil:
      return go(thread, look.holds(statement.condition, thread) ? place.next : place.targets[0]);
    case StatementKind::Parallel: return ofFork(thread, place);
    case StatementKind::Set: return go(thread, place.next, &statement.effects);
    case StatementKind::Success:
    case StatementKind::Failure: return ofOutcome(thread, statement);
    case StatementKind::Emit: return ofEmit(thread, place);
    case StatementKind::Choose:
      for (const int target : place.targets) go(thread, target);
      return;
    case StatementKind::Break:
    case StatementKind::Goto:
    case StatementKind::Printf: return go(thread, place.next);
    case StatementKind::Label:
    case StatementKind::Unknown: return;
    }
  }

  void go(int thread, int target, const syntax::Effects* effects = nullptr,
          When when = When::now()) {
    auto gone = change(when);
    if (effects) gone.setEffects(*effects);
    gone.goTo(thread, target);
    add(std::move(gone));
  }

  [[nodiscard]] int armOf(int thread, const Place& place) const {
    const auto& arms = place.statement->arms;
    for (std::size_t i = 0; i < arms.size(); ++i)
      if (!arms[i].condition || look.holds(*arms[i].condition, thread)) return place.targets[i];
    return place.next;
  }

  void ofBodyEnd(int thread) {
    const auto& of = script.threads[thread];
    if (of.skill == kNobody) return;
    if (!of.isBranch())
      return end(of.skill, plainSuccess(*script.skills[of.skill].node), When::now());
    auto ended = change();
    ended.endBranch(thread);
    add(std::move(ended));
  }

  /// The first branch that ends the skill decides how.
  void ofOutcome(int thread, const Statement& statement) {
    const auto& of = script.threads[thread];
    const auto ending = endingOf(*script.skills[of.skill].node, statement);
    if (!of.isBranch()) return end(of.skill, ending, When::now());
    auto ended = change();
    auto& decided = ended.after().decided[of.skill];
    if (!decided) decided = ending;
    ended.endBranch(thread);
    add(std::move(ended));
  }

  void ofFork(int thread, const Place& place) {
    auto forked = change();
    for (const int branch : place.branches) forked.goTo(branch, 0, Control::Called);
    forked.wait(thread, Control::Within);
    add(std::move(forked));
  }

  void ofJoin(int thread, const Place& place) {
    if (now.decided[script.threads[thread].skill]) return;
    for (const int branch : place.branches)
      if (now.threads[branch].control != Control::Off) return;
    go(thread, place.next);
  }

  // --- Calls

  [[nodiscard]] bool isFree(int callee) const { return now.skills[callee].caller == kNobody; }

  void ofNewCall(int thread, const Place& place) {
    if (isFree(script.skill(place.statement->head.text))) return takeCall(thread, place);
    auto found = change();
    found.note(What::CallBusy, script.threads[thread].skill, place.statement->range.begin);
    found.wait(thread, Control::Busy);
    add(std::move(found));
  }

  void ofBusy(int thread, const Place& place) {
    if (isFree(script.skill(place.statement->head.text))) takeCall(thread, place);
  }

  void takeCall(int thread, const Place& place) {
    auto called = change();
    called.call(script.skill(place.statement->head.text), thread);
    called.wait(thread, Control::Within);
    add(std::move(called));
  }

  void ofCall(int thread, const Place& place) {
    const int callee = script.skill(place.statement->head.text);
    if (isOutstanding(callee, thread)) return;
    auto returned = change();
    if (now.skills[callee].last.status == Status::None)
      returned.note(What::CallRefused, script.threads[thread].skill, place.statement->range.begin);
    returned.seeReturn(callee, thread);
    returned.goTo(thread, place.next);
    add(std::move(returned));
  }

  [[nodiscard]] bool isCalledOrRuns(int skill) const {
    const auto phase = now.skills[skill].phase;
    return phase == Phase::Called || phase == Phase::Running;
  }

  void ofInterrupt(int thread, const Place& place) {
    const int target = script.skill(place.statement->name.text);
    const bool canBe = target != kNobody && script.skills[target].node->interrupt;
    if (script.threads[thread].skill == kNobody && canBe && isCalledOrRuns(target)) {
      if (takesInterrupts(target)) interruptFromOutside(target, When::now(), thread, place.next);
      return;
    }
    auto made = change();
    if (canBe && isCalledOrRuns(target)) made.after().skills[target].stop = true;
    made.goTo(thread, place.next);
    add(std::move(made));
  }

  // --- The world

  void ofEmit(int thread, const Place& place) {
    auto emitted = change();
    occur(emitted, script.event(place.statement->name.text));
    emitted.goTo(thread, place.next);
    add(std::move(emitted));
  }

  void occur(Change& made, int event) const {
    made.note(What::Occurs, event);
    made.setEffects(script.events[event]->effects);
  }

  /// Without an environment of its own, everything may happen at any time.
  void ofTheWorld() {
    for (int event = 0; event < static_cast<int>(script.events.size()); ++event) {
      auto happens = change(When::anyTime());
      occur(happens, event);
      add(std::move(happens));
    }
    for (int skill = 0; skill < static_cast<int>(script.skills.size()); ++skill)
      if (script.skills[skill].node->interrupt && isCalledOrRuns(skill) && takesInterrupts(skill))
        interruptFromOutside(skill, When::anyTime(), kNobody, 0);
  }

  /// A composite skill notices an interrupt from outside where it waits for something.
  [[nodiscard]] bool takesInterrupts(int skill) const {
    if (now.skills[skill].phase == Phase::Called) return true;
    const int body = script.skills[skill].body;
    return body == kNobody || isWaiting(body);
  }

  void interruptFromOutside(int skill, When when, int thread, int next) {
    auto made = change(when);
    const auto ending = interruptionOf(*script.skills[skill].node);
    if (now.skills[skill].phase == Phase::Called)
      made.stopBeforeStart(skill);
    else if (script.skills[skill].isComposite())
      made.strike(script.skills[skill].body, ending);
    else
      made.endSkill(skill, ending);
    if (thread != kNobody) made.goTo(thread, next);
    add(std::move(made));
  }

  /// When the mission has ended, nothing more is asked of the program: it may idle for ever.
  void ofTheEnd() {
    const auto isOver = [&](std::size_t i) { return now.skills[i].phase == Phase::Ended; };
    for (std::size_t i = 0; i < script.skills.size(); ++i) {
      const bool counts = script.mission == kNobody || script.mission == static_cast<int>(i);
      if (!counts || !isOver(i)) continue;
      return add(change(When::anyTime()));
    }
  }

  const Script& script;
  const Situation& now;
  Look look;
  std::vector<Step> all;
};

std::int64_t initialValue(const Script& script, int index) {
  const auto& variable = *script.variables[index];
  if (variable.isNatural()) return variable.init.number.numerator;
  for (std::size_t i = 0; i < variable.states.size(); ++i)
    if (variable.states[i].text == variable.init.name.text) return static_cast<std::int64_t>(i);
  return 0;
}

} // namespace

Situation beginning(const Script& script) {
  Situation first;
  for (int i = 0; i < static_cast<int>(script.variables.size()); ++i)
    first.values.push_back(initialValue(script, i));
  first.used.assign(script.resources.size(), 0);
  first.skills.resize(script.skills.size());
  first.decided.resize(script.skills.size());
  first.threads.resize(script.threads.size());
  first.ages.resize(script.threads.size() + script.skills.size());
  for (std::size_t i = 0; i < script.threads.size(); ++i)
    for (const int skill : script.threads[i].calls)
      if (script.skills[skill].isShared())
        for (int at = static_cast<int>(i); at != kNobody; at = script.threads[at].parent)
          first.own[{at, skill}] = {};
  Change begun(script, first, When::now());
  for (std::size_t i = 0; i < script.skills.size(); ++i)
    if (script.skills[i].root) begun.call(static_cast<int>(i), kRoot);
  if (script.environment != kNobody)
    begun.goTo(script.environment, script.threads[script.environment].entry);
  return begun.take().after;
}

std::vector<Step> stepsFrom(const Script& script, const Situation& situation) {
  return Steps(script, situation).find();
}

} // namespace proskill::meaning
