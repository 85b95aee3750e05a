#include "bridge/bt/emit/calls.h"

#include "analysis/program/outcomes.h"
#include "bridge/bt/emit/elements.h"
#include "syntax/tree/statements.h"

#include <algorithm>

namespace proskill::bridge::bt {

using analysis::Definition;
using syntax::ExprKind;

namespace {

/// Whether a port with this value has that of an entry of the blackboard.
bool isReference(std::string_view value) {
  const auto first = value.find_first_not_of(' ');
  const auto last = value.find_last_not_of(' ');
  return first < last && value[first] == '{' && value[last] == '}';
}

} // namespace

Element Calls::call(const syntax::Statement& call, analysis::FileId file) {
  const auto& skill = *draft.program.skills.find(call.head.text);
  want(skill);
  auto node = element(skill->isComposite() ? "SubTree" : "Action", {{"ID", nameOf(skill)}});
  for (const auto& argument : call.arguments)
    node.attributes.emplace_back(argument.name.text, value(argument, file));
  return node;
}

std::string Calls::nameOf(const Definition<syntax::Skill>& skill) {
  const bool isRenamed = builtIn(skill.name()) != nullptr && skill->isComposite();
  return std::string(skill.name()) + (isRenamed ? "_tree" : "");
}

std::string Calls::value(const syntax::Argument& argument, analysis::FileId file) {
  const auto& name = argument.name.text;
  if (name == "ID" || name == "name" || name.starts_with('_'))
    draft.fail({file, argument.name.range}, "a port with this name");
  const auto& expr = argument.value;
  const bool isEntry =
      expr.kind == ExprKind::Symbol && draft.program.stateVariables.find(expr.name.text) != nullptr;
  if (expr.kind == ExprKind::True) return "true";
  if (expr.kind == ExprKind::False) return "false";
  if (expr.kind == ExprKind::Number) return syntax::toString(expr.number);
  if (expr.kind == ExprKind::String && isReference(expr.name.text))
    draft.fail({file, argument.range}, "a string in braces, which a port reads as an entry");
  if (expr.kind == ExprKind::String) return std::string(expr.name.text);
  if (expr.kind == ExprKind::Parameter) return fmt::format("{{{}}}", expr.name.text.substr(1));
  if (expr.kind == ExprKind::Symbol && !isEntry) return std::string(expr.name.text);
  draft.fail({file, argument.range}, "an argument that is computed");
  return {};
}

void Calls::want(const Definition<syntax::Skill>& skill) {
  if (!known.insert(skill.name()).second) return;
  const bool isReserved = builtIn(skill.name()) != nullptr;
  const bool isTaken = isReserved && draft.program.skills.find(nameOf(skill)) != nullptr;
  if (isTaken) // also of a leaf, which keeps its name
    draft.fail(skill.at(skill->name.range), "a skill with the name of a built-in node");
  checkFields(skill);
  checkEffects(skill);
  if (skill->isComposite())
    composites.push_back(&skill);
  else
    leaves.push_back(&skill);
}

/// A leaf does what its skill declares, and fails where it is refused or stopped. A tree does not.
void Calls::checkFields(const Definition<syntax::Skill>& skill) {
  const auto check = [&](syntax::Range at, std::string_view what) {
    if (skill->isComposite()) return draft.fail(skill.at(at), what);
    draft.note(skill.at(at), fmt::format("{}: that is up to the leaf", what));
  };
  for (const auto& each : skill->preconditions) check(each.range, "a precondition");
  for (const auto& each : skill->invariants)
    if (!skill->isComposite()) check(each.range, "an invariant");
  for (const auto& each : skill->resources) check(each.range, "a resource");
  if (skill->interrupt) check(skill->interrupt->range, "an interruption from outside");
  if (skill->unstoppable)
    draft.fail(skill.at(skill->name.range), "a skill that must not be stopped");
  if (skill->monitor || skill->armed) draft.fail(skill.at(skill->name.range), "a monitor");
  if (skill->isComposite() && skill->timeInterval)
    draft.note(skill.at(skill->timeInterval->range), "the least and the greatest time of a body");
}

void Calls::checkEffects(const Definition<syntax::Skill>& skill) {
  const auto effects = [&](const syntax::Effects& all) {
    if (all.items.empty()) return;
    const auto at = skill.at(all.items.front().range);
    if (skill->isComposite()) return draft.fail(at, "an effect of a composite skill");
    draft.note(at, "an effect: that is up to the leaf");
  };
  effects(skill->start);
  if (skill->isComposite())
    for (const auto& guard : skill->invariants) effects(guard.effects);
  for (const auto* outcomes : {&skill->successes, &skill->failures})
    for (const auto& outcome : *outcomes) {
      effects(outcome.effects);
      if (outcome.postcondition)
        draft.note(skill.at(outcome.postcondition->range), "a postcondition");
    }
}

std::set<std::string_view> Calls::calledIn(const syntax::Block& block) const {
  std::set<std::string_view> called;
  syntax::forEachStatement(block, [&](const syntax::Statement& each) {
    if (each.kind == syntax::StatementKind::Call) called.insert(each.head.text);
  });
  std::vector<std::string_view> open(called.begin(), called.end());
  while (!open.empty()) {
    const auto& skill = *draft.program.skills.find(open.back());
    open.pop_back();
    if (!skill->body) continue;
    syntax::forEachStatement(*skill->body, [&](const syntax::Statement& each) {
      if (each.kind == syntax::StatementKind::Call && called.insert(each.head.text).second)
        open.push_back(each.head.text);
    });
  }
  return called;
}

std::set<std::string_view> Calls::statusesOf(std::string_view name) const {
  std::set<std::string_view> statuses;
  for (const auto& outcome : analysis::outcomesOf(draft.program.skills.find(name)->node()))
    statuses.insert(outcome.status == "refused" ? "no_status" : outcome.status);
  return statuses;
}

Ends Calls::endsOf(std::string_view name) const {
  const auto statuses = statusesOf(name);
  const bool succeeds = statuses.contains("success");
  return {succeeds, statuses.size() > (succeeds ? 1U : 0U)};
}

std::set<const syntax::Block*> Calls::armsFor(const syntax::Statement& statement,
                                              std::string_view name, bool succeeded) const {
  std::set<const syntax::Block*> arms;
  for (const auto& outcome : analysis::outcomesOf(draft.program.skills.find(name)->node())) {
    if ((outcome.status == "success") != succeeded) continue;
    const auto found = std::ranges::find_if(statement.arms, [&](const syntax::Arm& arm) {
      return analysis::matches(arm.pattern, outcome);
    });
    arms.insert(found == statement.arms.end() ? nullptr : &found->body);
  }
  return arms;
}

} // namespace proskill::bridge::bt
