#include "bridge/bt/emit/variables.h"

#include "syntax/tree/statements.h"

#include <algorithm>

namespace proskill::bridge::bt {

Variables::Variables(const analysis::Program& program) : program(program) {
  for (const auto& each : program.skills.all) skill(each.node());
  for (const auto& each : program.environments.all)
    syntax::forEachStatement(each->body, [&](const auto& it) { effects(it.effects, bySkills); });
  for (const auto& each : program.events.all) {
    effects(each->effects, byEvents);
    // Where there is an environment, events do not occur by themselves.
    if (each->guard || each->every || onlyVariableOf(each.node()).empty() ||
        !program.environments.all.empty())
      effects(each->effects, restricted);
    else
      free[onlyVariableOf(each.node())].insert(each->effects.items.front().value.name.text);
  }
}

void Variables::effects(const syntax::Effects& all, std::set<std::string_view>& variables) {
  for (const auto& effect : all.items) variables.insert(effect.variable.text);
}

void Variables::skill(const syntax::Skill& skill) {
  effects(skill.start, bySkills);
  for (const auto& invariant : skill.invariants) effects(invariant.effects, bySkills);
  if (skill.interrupt) effects(skill.interrupt->effects, bySkills);
  for (const auto* outcomes : {&skill.successes, &skill.failures})
    for (const auto& outcome : *outcomes) effects(outcome.effects, bySkills);
  if (!skill.body) return;
  syntax::forEachStatement(*skill.body, [&](const auto& it) { effects(it.effects, byBodies); });
}

std::string_view Variables::onlyVariableOf(const syntax::Event& event) {
  return event.effects.items.size() == 1 ? event.effects.items.front().variable.text
                                         : std::string_view();
}

bool Variables::isFree(const syntax::StateVariable& variable) const {
  const auto reached = free.find(variable.name.text);
  return reached != free.end() &&
         std::ranges::all_of(variable.states, [&](const syntax::Name& state) {
           return reached->second.contains(state.text);
         });
}

Changed Variables::changed(std::string_view name) const {
  const auto& variable = *program.stateVariables.find(name);
  const bool byEvent = byEvents.contains(name);
  if (bySkills.contains(name) || restricted.contains(name) ||
      variable->transitionsKind == syntax::Transitions::Listed)
    return Changed::Otherwise;
  const bool severalInits = !variable->otherInits.empty();
  if (byBodies.contains(name) || variable->isNatural())
    return byEvent || severalInits ? Changed::Otherwise : Changed::ByBodies;
  if (byEvent) return isFree(variable.node()) ? Changed::Freely : Changed::Otherwise;
  return variable->otherInits.size() + 1 == variable->states.size() ? Changed::Never
                                                                    : Changed::Otherwise;
}

} // namespace proskill::bridge::bt
