#include "tests/meaning/step.h"

#include <algorithm>

namespace proskill::meaning {
namespace {

bool isAllowed(const syntax::StateVariable& variable, std::int64_t from, std::int64_t to) {
  if (from == to || variable.transitionsKind != syntax::Transitions::Listed) return true;
  return std::ranges::any_of(variable.transitions, [&](const auto& move) {
    return move.from.text == variable.states[from].text && move.to.text == variable.states[to].text;
  });
}

What whatOf(Status status) {
  switch (status) {
  case Status::None: break;
  case Status::Success: return What::Succeeds;
  case Status::Failure: return What::Fails;
  case Status::FailedInvariant: return What::InvariantFails;
  case Status::Interrupted: return What::IsInterrupted;
  }
  return What::Refused;
}

/// An end before a lower bound violates it; for an open one, an end at the bound does, too.
bool isTooEarly(const Age& age, std::int64_t lower, bool open) {
  if (age.beyond) return false;
  return age.whole < lower || (open && age.whole == lower && age.fraction == 0);
}

} // namespace

/// All values are computed before the first is set.
void Change::setEffects(const syntax::Effects& effects) {
  const Situation before = step.after;
  const Look look(script, before);
  for (const auto& effect : effects.items) {
    const int index = script.variable(effect.variable.text);
    const auto& variable = *script.variables[index];
    auto& value = step.after.values[index];
    if (variable.isNatural()) {
      const auto wanted = look.number(effect.value);
      const auto low = variable.min ? variable.min->number.numerator : 0;
      const auto high = variable.max->number.numerator;
      value = std::clamp(wanted, low, high);
      if (value != wanted) note(What::Forbidden, index);
    } else {
      const auto wanted = look.valueFor(index, effect.value);
      if (!isAllowed(variable, before.values[index], wanted)) note(What::Forbidden, index);
      value = wanted;
    }
  }
}

// --- Calls

/// The call resets the status for everybody.
void Change::call(int skill, int caller, std::vector<std::int64_t> given) {
  auto& called = state(skill);
  called.given = std::move(given);
  called.phase = Phase::Called;
  called.caller = caller;
  called.last = {};
  if (caller >= 0) tellCallers(caller, skill, {});
}

/// A skill with several callers stays busy until its caller has noticed the end.
void Change::returnFrom(int skill) {
  auto& done = state(skill);
  done.stop = false;
  done.given.clear();
  const bool waits = script.skills[skill].isShared() && done.caller != kRoot;
  done.phase = waits                                 ? Phase::Returned
               : script.skills[skill].startsItself() ? Phase::Ended
                                                     : Phase::Idle;
  if (!waits) done.caller = kNobody;
}

void Change::seeReturn(int skill, int thread) {
  tellCallers(thread, skill, state(skill).last);
  if (state(skill).phase != Phase::Returned) return;
  state(skill).phase = Phase::Idle;
  state(skill).caller = kNobody;
}

/// The calling thread, and those around it, keep an outcome of their own if the skill has other
/// callers.
void Change::tellCallers(int thread, int skill, const Outcome& outcome) {
  if (!script.skills[skill].isShared()) return;
  for (int at = thread; at != kNobody; at = script.threads[at].parent)
    step.after.own[{at, skill}] = outcome;
}

void Change::askToStop(int skill, int thread) {
  auto& called = state(skill);
  if (called.caller == thread && called.phase != Phase::Returned) called.stop = true;
}

// --- Skills

void Change::startSkill(int skill) {
  const auto& entry = script.skills[skill];
  note(What::Runs, skill, entry.node->name.range.begin);
  state(skill).phase = Phase::Running;
  changeResources(skill, 1);
  setEffects(entry.node->start);
  if (entry.node->timeInterval) ageOf(skill) = {.counts = true};
  if (entry.isComposite()) goTo(entry.body, script.threads[entry.body].entry);
}

void Change::refuse(int skill) {
  if (state(skill).caller == kRoot) note(What::Refused, skill);
  returnFrom(skill);
}

void Change::stopBeforeStart(int skill) {
  const auto& node = *script.skills[skill].node;
  if (node.interrupt) note(What::IsInterrupted, skill, node.interrupt->range.begin);
  state(skill).last = {Status::Interrupted};
  returnFrom(skill);
}

void Change::endSkill(int skill, const Ending& ending) {
  note(whatOf(ending.outcome.status), skill, ending.at);
  if (ending.effects) setEffects(*ending.effects);
  if (ending.postcondition && !Look(script, step.after).holds(*ending.postcondition))
    note(What::PostconditionFails, skill, ending.postconditionAt);
  noteDuration(skill);
  state(skill).last = ending.outcome;
  ageOf(skill) = {};
  changeResources(skill, -1);
  if (script.skills[skill].isComposite()) {
    step.after.decided[skill].reset();
    goTo(script.skills[skill].body, 0, Control::Off);
  }
  returnFrom(skill);
}

void Change::noteDuration(int skill) {
  const auto& entry = script.skills[skill];
  if (!entry.isComposite() || !entry.node->timeInterval) return;
  const auto& interval = *entry.node->timeInterval;
  if (!isTooEarly(ageOf(skill), script.units(interval.lower), interval.lowerOpen)) return;
  // Noticed after some time has passed; with an open bound at once.
  if (interval.lowerOpen)
    note(What::Undershoot, skill, interval.range.begin);
  else
    state(skill).endedEarly = true;
}

void Change::changeResources(int skill, int by) {
  for (const auto& name : script.skills[skill].node->resources)
    for (std::size_t i = 0; i < script.resources.size(); ++i)
      if (script.resources[i]->name.text == name.text) step.after.used[i] += by;
}

// --- Threads

void Change::goTo(int thread, int place, Control control) {
  auto& state = step.after.threads[thread];
  state = {.control = control, .place = place, .stop = state.stop};
  if (control == Control::Off) state.stop = false;
  const auto* statement = script.threads[thread].places[place].statement;
  const bool waits = control == Control::Before && statement && waitsForTime(*statement);
  step.after.ages[thread] = {.counts = waits};
}

void Change::endBranch(int thread) { goTo(thread, 0, Control::Off); }

void Change::stopRivals(int thread) {
  for (const int rival : script.threads[thread].rivals)
    if (step.after.threads[rival].control != Control::Off) step.after.threads[rival].stop = true;
}

void Change::strike(int thread, const Ending& ending) {
  auto& state = step.after.threads[thread];
  const auto& place = script.threads[thread].places[state.place];
  if (state.control == Control::Within) {
    for (const int branch : place.branches)
      if (step.after.threads[branch].control != Control::Off)
        step.after.threads[branch].stop = true;
    if (place.branches.empty()) askToStop(script.skill(place.call->head.text), thread);
  }
  const bool within = state.control == Control::Within;
  const int at = state.place;
  goTo(thread, at, Control::Stopping);
  state.ending = ending;
  state.waits = within;
}

} // namespace proskill::meaning
