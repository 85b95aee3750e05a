#include "codegen/term/context.h"

#include "analysis/names/types.h"

#include <algorithm>

namespace proskill::codegen {

fiacre::Expr Context::cellField(std::string_view thread, std::string_view field) {
  return codegen::field(element(name("skill"), name(names.cell(thread))), field);
}

std::optional<Operand> Context::operand(const syntax::Expr& expr) {
  if (expr.kind == syntax::ExprKind::Symbol) {
    const auto* variable = program.stateVariables.find(expr.name.text);
    if (!variable) return std::nullopt;
    return Operand{names.variable(expr.name.text), &variable->node()};
  }
  if (expr.kind != syntax::ExprKind::Parameter || !writtenIn) return std::nullopt;
  for (const auto& input : writtenIn->skill().inputs)
    if (input.name.text == expr.name.text)
      return Operand{names.input(writtenIn->name(), input.name.text), typeOf(input)};
  return std::nullopt;
}

const syntax::StateVariable* Context::typeOf(const syntax::Input& input) const {
  return analysis::isTruthValue(input) ? nullptr : &stateVariable(input.type.text);
}

fiacre::Expr Context::outcomeField(std::string_view skill, std::string_view field) {
  const auto owner = plan.ownOutcomes.ownerFor(reader, skill);
  return owner.empty() ? cellField(skill, field) : ownField(owner, skill, field);
}

fiacre::Expr Context::ownField(std::string_view thread, std::string_view skill,
                               std::string_view field) {
  return name(names.own(thread, skill, field));
}

fiacre::Expr Context::result(std::string_view skill, std::string_view status,
                             std::string_view tag) {
  const auto& constructor = names.result(skill, status, tag);
  if (std::ranges::find(results, constructor) == results.end()) results.push_back(constructor);
  return name(constructor);
}

Actor actorOf(const SkillPlan& skill) { return {std::string(skill.name()), skill.file()}; }

Actor actorOf(const SkillPlan& skill, const BodyAutomaton& thread) {
  auto actor = actorOf(skill);
  std::string separator = " branch ";
  for (const auto index : thread.path) {
    actor.name += separator + std::to_string(index);
    separator = ".";
  }
  return actor;
}

} // namespace proskill::codegen
