#include "tests/meaning/situation_steps.h"

#include <algorithm>

namespace proskill::meaning {

namespace {

bool isWait(StatementKind kind) {
  return kind == StatementKind::WaitCondition || kind == StatementKind::WaitTime;
}

std::int64_t valueOf(const syntax::StateVariable& variable, const syntax::Expr& init) {
  if (variable.isNatural()) return init.number.numerator;
  for (std::size_t i = 0; i < variable.states.size(); ++i)
    if (variable.states[i].text == init.name.text) return static_cast<std::int64_t>(i);
  return 0;
}

} // namespace

std::vector<Step> Steps::find() {
  for (int skill = 0; skill < static_cast<int>(script.skills.size()); ++skill) ofSkill(skill);
  for (int thread = 0; thread < static_cast<int>(script.threads.size()); ++thread) ofThread(thread);
  if (script.environment == kNobody) ofTheWorld();
  ofEvents();
  ofTheEnd();
  return std::move(all);
}

void Steps::ofSkill(int skill) {
  const auto& state = now.skills[skill];
  if (script.skills[skill].calledByAnyone && state.phase == Phase::Idle)
    for (auto& given : anyArguments(skill)) {
      auto called = change(When::anyTime());
      called.call(skill, kRoot, std::move(given));
      add(std::move(called));
    }
  if (state.phase == Phase::Called) ofCalled(skill);
  if (state.phase == Phase::Ended) ofEnded(skill);
  if (state.phase == Phase::Running && !script.skills[skill].isComposite()) ofRunning(skill);
}

/// The least and the greatest value that an input can have.
std::pair<std::int64_t, std::int64_t> Steps::valuesOf(const InputEntry& input) const {
  if (input.variable == kNobody) return {0, 1};
  const auto& type = *script.variables[input.variable];
  if (!type.isNatural()) return {0, static_cast<std::int64_t>(type.states.size()) - 1};
  return {type.min ? type.min->number.numerator : 0, type.max->number.numerator};
}

/// All arguments with which anybody could call it.
std::vector<std::vector<std::int64_t>> Steps::anyArguments(int skill) const {
  std::vector<std::vector<std::int64_t>> all{{}};
  for (const auto& input : script.skills[skill].inputs) {
    const auto [low, high] = valuesOf(input);
    std::vector<std::vector<std::int64_t>> longer;
    for (const auto& known : all)
      for (auto value = low; value <= high; ++value) {
        longer.push_back(known);
        longer.back().push_back(value);
      }
    all = std::move(longer);
  }
  return all;
}

void Steps::ofCalled(int skill) {
  if (now.skills[skill].stop) {
    auto stopped = change();
    stopped.stopBeforeStart(skill);
    return add(std::move(stopped));
  }
  if (look.someGuardFails() || !resourcesAreFree(skill)) return;
  auto begun = change();
  const bool holds = look.preconditionHolds(skill);
  if (!holds && script.skills[skill].node->armed) return;
  if (holds)
    begun.startSkill(skill);
  else
    begun.refuse(skill);
  add(std::move(begun));
}

/// A monitor that is `always` armed waits until its precondition is false, and then for it again.
void Steps::ofEnded(int skill) {
  if (!script.skills[skill].node->armed || look.preconditionHolds(skill)) return;
  auto armed = change();
  armed.call(skill, kRoot);
  add(std::move(armed));
}

bool Steps::resourcesAreFree(int skill) const {
  return std::ranges::all_of(script.skills[skill].node->resources, [&](const auto& name) {
    for (std::size_t i = 0; i < script.resources.size(); ++i) {
      const auto& resource = *script.resources[i];
      const auto capacity = resource.capacity ? resource.capacity->number.numerator : 1;
      if (resource.name.text == name.text) return now.used[i] < capacity;
    }
    return false;
  });
}

void Steps::ofRunning(int skill) {
  const auto& node = *script.skills[skill].node;
  const int clock = static_cast<int>(script.threads.size()) + skill;
  const auto when = node.timeInterval ? within(*node.timeInterval, clock) : When::anyTime();
  for (const auto& ending : outcomesOf(node)) end(skill, ending, when);
  if (now.skills[skill].stop && !node.unstoppable) end(skill, interruptionOf(node), When::now());
  for (const auto& invariant : node.invariants)
    if (!look.holds(invariant.guard)) end(skill, failureOf(invariant), When::now());
}

void Steps::end(int skill, const Ending& ending, When when) {
  auto ended = change(when);
  ended.endSkill(skill, ending);
  add(std::move(ended));
}

When Steps::within(const syntax::Interval& seconds, int clock) const {
  When when{.clock = clock, .lower = script.units(seconds.lower)};
  when.lowerOpen = seconds.lowerOpen;
  if (!seconds.upper) return when;
  when.upper = script.units(*seconds.upper);
  when.upperOpen = seconds.upperOpen;
  return when;
}

void Steps::ofThread(int thread) {
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
    else if (place.call)
      ofCall(thread, place);
    else
      ofJoin(thread, place);
  }
  if (isWaiting(thread)) ofStop(thread);
  ofGuards(thread);
}

bool Steps::mayGoOn(int thread) const {
  const int skill = script.threads[thread].skill;
  return skill == kNobody || (look.guardsHold(skill) && !hasLost(thread));
}

/// Another branch has won a race that contains the thread.
bool Steps::hasLost(int thread) const {
  for (int at = thread; at != kNobody; at = script.threads[at].parent)
    if (now.threads[at].stop && !script.threads[at].rivals.empty()) return true;
  return false;
}

bool Steps::isInRace(int thread) const {
  for (int at = thread; at != kNobody; at = script.threads[at].parent)
    if (!script.threads[at].rivals.empty()) return true;
  return false;
}

bool Steps::isWaiting(int thread) const {
  const auto& state = now.threads[thread];
  if (state.control == Control::Busy || state.control == Control::Within) return true;
  const auto* statement = script.threads[thread].places[state.place].statement;
  return state.control == Control::Before && statement && isWait(statement->kind);
}

void Steps::ofCalledBranch(int thread) {
  auto made = change();
  if (now.threads[thread].stop)
    made.endBranch(thread);
  else
    made.goTo(thread, script.threads[thread].entry);
  add(std::move(made));
}

void Steps::ofStopping(int thread) {
  const auto& state = now.threads[thread];
  const auto& of = script.threads[thread];
  const auto& place = of.places[state.place];
  auto made = change();
  if (state.waits) {
    for (const int branch : place.branches)
      if (now.threads[branch].control != Control::Off) return;
    if (place.branches.empty()) {
      const int callee = script.skill(place.call->head.text);
      if (isOutstanding(callee, thread)) return;
      // after a race the body continues, and may read the outcomes of what was stopped
      if (now.skills[callee].caller == thread && isInRace(thread)) {
        made.seeReturn(callee, thread);
      } else if (now.skills[callee].caller == thread) {
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

bool Steps::isOutstanding(int callee, int thread) const {
  const auto& state = now.skills[callee];
  return state.caller == thread && state.phase != Phase::Returned;
}

void Steps::strike(int thread, const Ending& ending) {
  auto struck = change();
  struck.strike(thread, ending);
  add(std::move(struck));
}

void Steps::ofStop(int thread) {
  const auto& of = script.threads[thread];
  if (of.skill == kNobody) return;
  if (of.isBranch()) {
    if (now.threads[thread].stop) strike(thread, {});
    return;
  }
  const auto& node = *script.skills[of.skill].node;
  if (now.skills[of.skill].stop && !node.unstoppable) strike(thread, interruptionOf(node));
  const bool joining = now.threads[thread].control == Control::Within &&
                       !of.places[now.threads[thread].place].branches.empty();
  if (joining && now.decided[of.skill]) strike(thread, *now.decided[of.skill]);
}

void Steps::ofGuards(int thread) {
  const auto& of = script.threads[thread];
  if (of.skill == kNobody) return;
  const auto& node = *script.skills[of.skill].node;
  if (of.isBranch()) {
    if (!mayGoOn(thread) && !isWaiting(thread) && now.threads[thread].stop) strike(thread, {});
    return;
  }
  for (const auto& invariant : node.invariants)
    if (!look.holds(invariant.guard)) strike(thread, failureOf(invariant));
}

void Steps::ofEmit(int thread, const Place& place) {
  const int event = script.event(place.statement->name.text);
  if (!mayOccur(event)) return;
  auto emitted = change();
  occur(emitted, event);
  emitted.goTo(thread, place.next);
  add(std::move(emitted));
}

void Steps::occur(Change& made, int event) const {
  made.note(What::Occurs, event);
  made.setEffects(script.events[event]->effects);
}

bool Steps::mayOccur(int event) const {
  const auto& guard = script.events[event]->guard;
  return !guard || look.holds(*guard);
}

/// Events with `:every`.
void Steps::ofEvents() {
  for (int event = 0; event < static_cast<int>(script.events.size()); ++event) {
    const auto& every = script.events[event]->every;
    if (!every) continue;
    const int clock = script.clockOfEvent(event);
    auto happens = change(within(*every, clock));
    occur(happens, event);
    happens.after().ages[clock] = {.counts = true};
    add(std::move(happens));
  }
}

void Steps::ofTheWorld() {
  for (int event = 0; event < static_cast<int>(script.events.size()); ++event) {
    if (script.events[event]->every || !mayOccur(event)) continue;
    auto happens = change(When::anyTime());
    occur(happens, event);
    add(std::move(happens));
  }
  for (int skill = 0; skill < static_cast<int>(script.skills.size()); ++skill)
    if (script.skills[skill].node->interrupt && isCalledOrRuns(skill) && takesInterrupts(skill))
      interruptFromOutside(skill, When::anyTime(), kNobody, 0);
}

bool Steps::takesInterrupts(int skill) const {
  if (now.skills[skill].phase == Phase::Called) return true;
  const int body = script.skills[skill].body;
  return body == kNobody || isWaiting(body);
}

void Steps::interruptFromOutside(int skill, When when, int thread, int next) {
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

void Steps::ofTheEnd() {
  const auto isOver = [&](std::size_t i) { return now.skills[i].phase == Phase::Ended; };
  for (std::size_t i = 0; i < script.skills.size(); ++i) {
    const bool counts = script.mission == kNobody || script.mission == static_cast<int>(i);
    if (!counts || !isOver(i)) continue;
    return add(change(When::anyTime()));
  }
}

std::vector<Situation> beginnings(const Script& script) {
  std::vector<Situation> all{beginning(script)};
  for (std::size_t i = 0; i < script.variables.size(); ++i) {
    const auto& variable = *script.variables[i];
    for (auto known = all.size(); known-- > 0;)
      for (const auto& other : variable.otherInits) {
        auto& made = all.emplace_back(Situation(all[known]));
        made.values[i] = valueOf(variable, other);
      }
  }
  return all;
}

Situation beginning(const Script& script) {
  Situation first;
  for (const auto* variable : script.variables)
    first.values.push_back(valueOf(*variable, variable->init));
  first.used.assign(script.resources.size(), 0);
  first.skills.resize(script.skills.size());
  first.decided.resize(script.skills.size());
  first.threads.resize(script.threads.size());
  first.ages.resize(script.threads.size() + script.skills.size() + script.events.size());
  for (std::size_t i = 0; i < script.events.size(); ++i)
    first.ages[script.clockOfEvent(static_cast<int>(i))].counts =
        script.events[i]->every.has_value();
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
