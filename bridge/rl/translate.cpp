#include "bridge/rl/translate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

namespace proskill::bridge::rl {

std::string_view typeOf(std::string type) {
  std::ranges::transform(type, type.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
  const auto isIn = [&](auto... words) { return ((type == words) || ...); };
  if (isIn("float", "double", "float32", "float64", "real")) return "float";
  if (isIn("int", "integer", "int8", "int16", "int32", "int64")) return "int";
  if (isIn("uint", "uint8", "uint16", "uint32", "uint64")) return "nat";
  if (isIn("bool", "boolean")) return "bool";
  return "string";
}

void Translation::add(const Skillset& skillset) {
  if (!skillsets.insert(skillset.name.text).second)
    errors.push_back(
        {skillset.name.place, fmt::format("a second skillset is called `{}`", skillset.name.text)});
  checkNames(skillset.events, "event");
  checkNames(skillset.skills, "skill");
  Scope scope(errors);
  for (const auto& resource : skillset.resources) variable(skillset, resource, scope);
  for (const auto& each : skillset.events) event(skillset, each, scope);
  for (const auto& each : skillset.skills) skill(skillset, each, scope);
  data += skillset.data.size() + skillset.parameters.size();
}

void Translation::checkNames(const auto& all, const char* kind) {
  std::set<std::string> seen;
  for (const auto& each : all)
    if (!seen.insert(each.name.text).second)
      errors.push_back(
          {each.name.place, fmt::format("a second {} is called `{}`", kind, each.name.text)});
}

std::string Translation::nameOf(const Skillset& skillset, const Word& word) {
  return names.take(several ? skillset.name.text + "_" + word.text : word.text);
}

std::string Translation::comment(const Word& word, const char* kind) const {
  return asComment(word.place, fmt::format("{} {}", kind, word.text), folder);
}

void Translation::variable(const Skillset& skillset, const Resource& resource, Scope& scope) {
  const auto name = nameOf(skillset, resource.name);
  scope.add(resource, name);
  std::vector<Form> states;
  for (const auto& state : resource.states)
    states.emplace_back(scope.stateOf(resource.name, state));
  const auto initial = scope.stateOf(resource.name, resource.initial);
  Form form = list("defsv", name, ":states", Form(states), ":init", initial);
  form.comment = comment(resource.name, "resource");
  form.parts.emplace_back(":transitions");
  std::vector<Form> moves;
  for (const auto& [from, to] : resource.moves) {
    Form move = list(scope.stateOf(resource.name, from), scope.stateOf(resource.name, to));
    if (std::ranges::find(moves, move) == moves.end()) moves.push_back(std::move(move));
  }
  // without a transition, only what stays is allowed
  if (moves.empty() && !resource.allMoves) moves.push_back(list(initial, initial));
  form.parts.push_back(resource.allMoves ? Form(":all") : Form(std::move(moves)));
  variables.push_back(std::move(form));
}

void Translation::event(const Skillset& skillset, const Event& event, Scope& scope) {
  Form form = list("defevent", nameOf(skillset, event.name));
  form.comment = comment(event.name, "event");
  if (event.effects.empty()) errors.push_back({event.name.place, "this event needs an `effect`"});
  if (event.guard) append(form.parts, {":guard", scope.condition(*event.guard)});
  append(form.parts, {":effects", scope.effects(event.effects)});
  events.push_back(std::move(form));
}

void Translation::skill(const Skillset& skillset, const Skill& skill, Scope& scope) {
  Callable called{nameOf(skillset, skill.name), {}, {}};
  for (const auto& input : skill.inputs) {
    called.inputs.push_back(asName(input.name.text));
    called.types.emplace_back(typeOf(input.type));
  }
  Form form = list("defskill", called.name);
  callable.emplace(std::pair(skillset.name.text, skill.name.text), std::move(called));
  form.comment = comment(skill.name, "skill");
  inputs(skill, form);
  NamePool tags;
  std::vector<Form> preconditions;
  for (const auto& each : skill.preconditions)
    append(preconditions, {tags.take(each.name.text), scope.condition(each.condition)});
  if (!preconditions.empty()) append(form.parts, {":precondition", Form(preconditions)});
  if (!skill.start.empty()) append(form.parts, {":start", scope.effects(skill.start)});
  std::vector<Form> invariants;
  NamePool results;
  for (const auto& each : skill.invariants) {
    Form clause = list(":guard", scope.condition(each.guard));
    if (!each.effects.empty()) append(clause.parts, {":effects", scope.effects(each.effects)});
    append(invariants, {results.take(each.name.text), clause});
  }
  if (!invariants.empty()) append(form.parts, {":invariant", Form(invariants)});
  Form command = list(asName(skill.name.text));
  for (const auto& input : skill.inputs) command.parts.emplace_back("$" + asName(input.name.text));
  append(form.parts, {":action", command});
  interrupt(skill, scope, form);
  checkNames(skill.successes, "success");
  checkNames(skill.failures, "failure");
  outcomes(skill.successes, ":success", results, scope, form);
  outcomes(skill.failures, ":failure", results, scope, form);
  skills.push_back(std::move(form));
  approximate(skill);
  outputs += skill.outputs.size();
  progresses += skill.progress ? 1 : 0;
}

void Translation::inputs(const Skill& skill, Form& form) {
  std::vector<Form> all;
  std::set<std::string> seen;
  for (const auto& input : skill.inputs) {
    const auto name = asName(input.name.text);
    if (!seen.insert(name).second)
      errors.push_back({input.name.place, fmt::format("a second input is called `{}`", name)});
    append(all, {"$" + name, std::string(typeOf(input.type))});
  }
  if (!all.empty()) append(form.parts, {":input", Form(std::move(all))});
}

void Translation::outcomes(const std::vector<Outcome>& all, const char* keyword, NamePool& tags,
                           Scope& scope, Form& form) {
  std::vector<Form> forms;
  for (const auto& outcome : all) {
    forms.emplace_back(tags.take(outcome.name.text));
    std::vector<Form> clause;
    if (!outcome.effects.empty()) append(clause, {":effects", scope.effects(outcome.effects)});
    if (outcome.postcondition)
      append(clause, {":postcondition", scope.condition(*outcome.postcondition)});
    if (!clause.empty()) forms.emplace_back(std::move(clause));
  }
  if (!forms.empty()) append(form.parts, {keyword, Form(std::move(forms))});
}

void Translation::interrupt(const Skill& skill, Scope& scope, Form& form) {
  if (!skill.interrupt) return;
  ++interrupts;
  Form clause{std::vector<Form>{}};
  if (!skill.interrupt->effects.empty())
    append(clause.parts, {":effects", scope.effects(skill.interrupt->effects)});
  append(form.parts, {":interrupt", clause});
  if (skill.interrupt->postcondition)
    static_cast<void>(scope.condition(*skill.interrupt->postcondition));
}

void Translation::approximate(const Skill& skill) {
  if (skill.successes.empty())
    notes.push_back({skill.name.place, fmt::format("`{}` has no `success`; in the program it may "
                                                   "succeed, without effects",
                                                   skill.name.text)});
  if (skill.interrupt && skill.interrupt->postcondition)
    unverified.push_back({skill.interrupt->place, "the postcondition of an interrupt"});
}

Block Translation::program() const {
  Block all = variables;
  append(all, events);
  append(all, skills);
  return all;
}

std::vector<std::string> Translation::omitted() const {
  std::vector<std::string> parts;
  if (data > 0) parts.push_back(counted(data, "datum or parameter", "data and parameters"));
  if (outputs > 0) parts.push_back(counted(outputs, "output", "outputs"));
  if (progresses > 0) parts.push_back(counted(progresses, "progress", "progresses"));
  if (parts.empty()) return {};
  return {fmt::format("not in the program, and without influence on verdicts: {}",
                      fmt::join(parts, ", "))};
}

} // namespace proskill::bridge::rl
