#include "codegen/term/effects.h"

#include "codegen/plan/mentions.h"
#include "codegen/term/conditions.h"
#include "codegen/term/grounds.h"
#include "codegen/term/linear.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::codegen {
namespace {

using fiacre::Op;
using fiacre::Statement;

/// Parts of an effect: the condition that raises an alarm, and the assignment.
struct Assignment {
  const syntax::Effect* effect;
  fiacre::Expr forbidden;
  std::string target;
  fiacre::Expr value;
};

/// Whether the variable has a value from which it must not move to `word`.
fiacre::Expr forbiddenFrom(Context& context, const syntax::StateVariable& variable,
                           std::string_view word) {
  const auto current = name(context.names.variable(variable.name.text));
  std::vector<fiacre::Expr> sources;
  for (const auto& from : variable.states)
    if (!isAllowed(variable, from.text, word))
      sources.push_back(equal(current, name(context.names.value(variable.name.text, from.text))));
  return disjunction(std::move(sources));
}

/// Whether the move to the value is forbidden now. A variable only moves to another value by a word
/// or by an input.
fiacre::Expr forbiddenMove(Context& context, const syntax::StateVariable& variable,
                           const syntax::Expr& value) {
  if (context.options.automata != StateVariableAutomata::Exact) return boolean(false);
  // a value may have the same name as its variable; otherwise that name is the current value
  if (value.kind == syntax::ExprKind::Symbol) {
    const bool isValue = std::ranges::any_of(
        variable.states, [&](const auto& it) { return it.text == value.name.text; });
    return isValue ? forbiddenFrom(context, variable, value.name.text) : boolean(false);
  }
  const auto input = name(context.operand(value)->variable);
  std::vector<fiacre::Expr> moves;
  for (const auto& to : variable.states)
    moves.push_back(
        conjunction({equal(input, name(context.names.value(variable.name.text, to.text))),
                     forbiddenFrom(context, variable, to.text)}));
  return disjunction(std::move(moves));
}

Assignment enumerationAssignment(Context& context, const syntax::Effect& effect,
                                 const syntax::StateVariable& variable) {
  return {.effect = &effect,
          .forbidden = forbiddenMove(context, variable, effect.value),
          .target = context.names.variable(variable.name.text),
          .value = enumerationValue(context, variable, effect.value)};
}

/// A natural that would leave its bounds raises the alarm, and stays at the bound.
Assignment naturalAssignment(Context& context, const syntax::Effect& effect,
                             const syntax::StateVariable& variable) {
  const Linear value(context, effect.value);
  const auto [low, high] = domainOf(variable);
  const auto below = Linear::compare(Op::Less, value, Linear(low));
  const auto above = Linear::compare(Op::Greater, value, Linear(high));
  return {.effect = &effect,
          .forbidden = disjunction({below, above}),
          .target = context.names.variable(variable.name.text),
          .value = conditional(below, number(low), conditional(above, number(high), value.expr()))};
}

/// In the compact edition, a tag in the same transition, and nothing else: a step of an automaton
/// that follows would be a step that the program does not take. The expanded edition has no test:
/// Fiacre's compiler makes a separate transition of a tag after a test. That transition would have
/// a clock of its own, which a transition with a time must not have.
Statement alarm(Context& context, const Actor& actor, const Assignment& assignment) {
  if (isFalse(assignment.forbidden)) return sequence({});
  const auto variable = assignment.effect->variable.text;
  context.alarmed.insert(variable);
  const auto words = fmt::format("makes a forbidden move: `{}`",
                                 context.origins.excerpt(actor.file, assignment.effect->range));
  const auto place = context.origins.of(actor, assignment.effect->range, words);
  context.alarms.emplace(place, Alarm::ForbiddenMove);
  const bool isNatural = context.stateVariable(variable).isNatural();
  (isNatural ? triesValue : triesMove)(context, place, *assignment.effect);
  if (!context.isExpanded())
    return ifThen(assignment.forbidden, at(place, tag(context.names.tag({variable, "forbidden"}))));
  const auto error = name(context.names.error(variable));
  return at(context.origins.of(actor, assignment.effect->range),
            assign(error, disjunction({error, assignment.forbidden})));
}

/// Whether an assignment reads what an earlier one has changed.
bool depend(const std::vector<Assignment>& assignments) {
  for (std::size_t i = 0; i < assignments.size(); ++i)
    for (std::size_t j = i + 1; j < assignments.size(); ++j)
      if (mentions(assignments[j].value, assignments[i].target)) return true;
  return false;
}

Statement assignAll(std::vector<Assignment> assignments) {
  std::vector<Statement> statements;
  const bool together = depend(assignments);
  for (auto& each : assignments) {
    if (!together || statements.empty()) {
      statements.push_back(assign(name(each.target), std::move(each.value)));
    } else {
      statements[0].targets.push_back(name(each.target));
      statements[0].values.push_back(std::move(each.value));
    }
  }
  return sequence(std::move(statements));
}

} // namespace

bool isAllowed(const syntax::StateVariable& variable, std::string_view from, std::string_view to) {
  if (from == to || variable.transitionsKind != syntax::Transitions::Listed) return true;
  return std::ranges::any_of(variable.transitions, [&](const auto& transition) {
    return transition.from.text == from && transition.to.text == to;
  });
}

Statement effects(Context& context, const Actor& actor, const syntax::Effects& effects) {
  std::vector<Assignment> assignments;
  for (const auto& effect : effects.items) {
    const auto& variable = context.stateVariable(effect.variable.text);
    assignments.push_back(variable.isNatural() ? naturalAssignment(context, effect, variable)
                                               : enumerationAssignment(context, effect, variable));
  }
  std::vector<Statement> statements;
  for (const auto& assignment : assignments)
    statements.push_back(alarm(context, actor, assignment));
  statements.push_back(assignAll(std::move(assignments)));
  return sequence(std::move(statements));
}

} // namespace proskill::codegen
