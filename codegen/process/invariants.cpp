#include "codegen/process/invariants.h"

#include "codegen/plan/mentions.h"
#include "codegen/term/conditions.h"
#include "codegen/term/inputs.h"

namespace proskill::codegen {
namespace {

/// Whether the skill is running and one of its guards is false. A skill that has noticed, and waits
/// for callees that must not be stopped, no longer holds up others.
fiacre::Expr failsIn(Context& context, const SkillPlan& skill) {
  const WrittenIn scope(context, skill);
  std::vector<fiacre::Expr> broken;
  for (const auto& invariant : skill.skill().invariants)
    broken.push_back(negation(condition(context, invariant.guard)));
  auto isEnding = skill.mayLinger() ? context.cellField(skill.name(), "ending") : boolean(false);
  return conjunction({context.cellField(skill.name(), "inv_active"), negation(std::move(isEnding)),
                      disjunction(std::move(broken))});
}

} // namespace

std::optional<fiacre::Function> invariantActive(Context& context) {
  std::vector<fiacre::Expr> cases;
  for (const auto& skill : context.plan.skills) cases.push_back(failsIn(context, skill));
  auto any = disjunction(std::move(cases));
  if (isFalse(any)) return std::nullopt;

  fiacre::Function function;
  function.name = "invariant_active";
  function.comment = "Whether an invariant has failed and its skill has not noticed yet.";
  function.parameters.push_back({"skill", namedType("skill_array"), false});
  for (const auto& variable : context.program.stateVariables.all)
    if (const auto& name = context.names.variable(variable.name()); mentions(any, name))
      function.parameters.push_back({name, namedType(context.names.type(variable.name())), false});
  for (const auto& input : inputVariables(context))
    if (mentions(any, input.name)) function.parameters.push_back({input.name, input.type, false});
  function.result = boolType();
  function.body.kind = fiacre::StatementKind::Return;
  function.body.values.push_back(std::move(any));
  return function;
}

fiacre::Expr someInvariantFails(const Context& context) {
  if (!context.invariantActive) return boolean(false);
  std::vector<fiacre::Expr> arguments;
  for (const auto& parameter : context.invariantActive->parameters)
    arguments.push_back(name(parameter.name));
  return call(context.invariantActive->name, std::move(arguments));
}

} // namespace proskill::codegen
