#include "tests/meaning/situation_steps.h"

#include <algorithm>
#include <stdexcept>

namespace proskill::meaning {

void Steps::ofStatement(int thread, const Place& place) {
  if (!place.statement) return ofBodyEnd(thread);
  const auto& statement = *place.statement;
  switch (statement.kind) {
  case StatementKind::Call:
  case StatementKind::Case: return ofNewCall(thread, place);
  case StatementKind::Interrupt: return ofInterrupt(thread, place);
  case StatementKind::WaitCondition:
    if (mayGoOn(thread) && look.holds(statement.condition, thread))
      go(thread, place.next, &statement.effects);
    if (!place.targets.empty())
      go(thread, place.targets[0], nullptr, within(statement.duration, thread));
    return;
  case StatementKind::WaitTime:
    return go(thread, place.next, nullptr, within(statement.duration, thread));
  case StatementKind::If: return go(thread, armOf(thread, place));
  case StatementKind::While:
    return go(thread, look.holds(statement.condition, thread) ? place.targets[0] : place.next);
  case StatementKind::DoUntil:
    return go(thread, look.holds(statement.condition, thread) ? place.next : place.targets[0]);
  case StatementKind::Parallel:
  case StatementKind::Race: return ofFork(thread, place);
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

void Steps::go(int thread, int target, const syntax::Effects* effects, When when) {
  auto gone = change(when);
  if (effects) gone.setEffects(*effects);
  gone.goTo(thread, target);
  add(std::move(gone));
}

int Steps::armOf(int thread, const Place& place) const {
  const auto& arms = place.statement->arms;
  for (std::size_t i = 0; i < arms.size(); ++i)
    if (!arms[i].condition || look.holds(*arms[i].condition, thread)) return place.targets[i];
  return place.next;
}

void Steps::ofBodyEnd(int thread) {
  const auto& of = script.threads[thread];
  if (of.skill == kNobody) return;
  if (!of.isBranch())
    return end(of.skill, plainSuccess(*script.skills[of.skill].node), When::now());
  auto ended = change();
  ended.stopRivals(thread);
  ended.endBranch(thread);
  add(std::move(ended));
}

void Steps::ofOutcome(int thread, const Statement& statement) {
  const auto& of = script.threads[thread];
  const auto ending = endingOf(*script.skills[of.skill].node, statement);
  if (!of.isBranch()) return end(of.skill, ending, When::now());
  auto ended = change();
  auto& decided = ended.after().decided[of.skill];
  if (!decided) decided = ending;
  ended.endBranch(thread);
  add(std::move(ended));
}

void Steps::ofFork(int thread, const Place& place) {
  auto forked = change();
  for (const int branch : place.branches) forked.goTo(branch, 0, Control::Called);
  forked.wait(thread, Control::Within);
  add(std::move(forked));
}

void Steps::ofJoin(int thread, const Place& place) {
  if (now.decided[script.threads[thread].skill]) return;
  for (const int branch : place.branches)
    if (now.threads[branch].control != Control::Off) return;
  go(thread, place.next);
}

void Steps::ofNewCall(int thread, const Place& place) {
  if (isFree(script.skill(place.call->head.text))) return takeCall(thread, place);
  auto found = change();
  found.note(What::CallBusy, script.threads[thread].skill, place.call->range.begin);
  found.wait(thread, Control::Busy);
  add(std::move(found));
}

void Steps::ofBusy(int thread, const Place& place) {
  if (isFree(script.skill(place.call->head.text))) takeCall(thread, place);
}

void Steps::takeCall(int thread, const Place& place) {
  auto called = change();
  called.call(script.skill(place.call->head.text), thread, argumentsOf(*place.call));
  called.wait(thread, Control::Within);
  add(std::move(called));
}

std::vector<std::int64_t> Steps::argumentsOf(const Statement& call) const {
  std::vector<std::int64_t> all;
  for (const auto& input : script.skills[script.skill(call.head.text)].inputs)
    for (const auto& argument : call.arguments)
      if (argument.name.text == input.name.substr(1))
        all.push_back(look.valueFor(input.variable, argument.value));
  return all;
}

void Steps::ofCall(int thread, const Place& place) {
  const int callee = script.skill(place.call->head.text);
  if (isOutstanding(callee, thread)) return;
  auto returned = change();
  if (now.skills[callee].last.status == Status::None)
    returned.note(What::CallRefused, script.threads[thread].skill, place.call->range.begin);
  returned.seeReturn(callee, thread);
  const bool isCase = place.statement->kind == StatementKind::Case;
  returned.goTo(thread, isCase ? armFor(now.skills[callee].last, place) : place.next);
  add(std::move(returned));
}

/// The first arm that matches the outcome. There must be one; otherwise the program would be stuck.
int Steps::armFor(const Outcome& outcome, const Place& place) {
  const auto& arms = place.statement->arms;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const auto& [status, tags, range] = arms[i].pattern;
    if (status.text == "else") return place.targets[i];
    const auto word = status.text == "refused" ? wordOf(Status::None) : status.text;
    if (word != wordOf(outcome.status)) continue;
    if (tags.empty() || std::ranges::find(tags, outcome.result, &syntax::Name::text) != tags.end())
      return place.targets[i];
  }
  throw std::logic_error("no arm of a case is for the outcome");
}

bool Steps::isCalledOrRuns(int skill) const {
  const auto phase = now.skills[skill].phase;
  return phase == Phase::Called || phase == Phase::Running;
}

void Steps::ofInterrupt(int thread, const Place& place) {
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

} // namespace proskill::meaning
