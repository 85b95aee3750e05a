#pragma once

#include "analysis/names/walk.h"
#include "analysis/program/program.h"

namespace proskill::codegen {

/// Calls `visit` for the expression and each of its parts.
template <class Visit> void forEachPart(const syntax::Expr& expr, Visit&& visit) {
  visit(expr);
  for (const auto& operand : expr.operands) forEachPart(operand, visit);
}

template <class Visit> void forEachExpression(const syntax::Effects& effects, Visit&& visit) {
  for (const auto& effect : effects.items) forEachPart(effect.value, visit);
}

template <class Visit> void forEachExpression(const syntax::Block& block, Visit&& visit) {
  analysis::forEachStatement(block, [&](const syntax::Statement& statement) {
    forEachPart(statement.condition, visit);
    forEachExpression(statement.effects, visit);
    for (const auto& arm : statement.arms)
      if (arm.condition) forEachPart(*arm.condition, visit);
  });
}

template <class Visit> void forEachExpression(const syntax::Outcome& outcome, Visit&& visit) {
  forEachExpression(outcome.effects, visit);
  if (outcome.postcondition) forEachPart(*outcome.postcondition, visit);
}

template <class Visit> void forEachExpression(const syntax::Skill& skill, Visit&& visit) {
  for (const auto& precondition : skill.preconditions) forEachPart(precondition.condition, visit);
  forEachExpression(skill.start, visit);
  for (const auto& invariant : skill.invariants) {
    forEachPart(invariant.guard, visit);
    forEachExpression(invariant.effects, visit);
  }
  if (skill.interrupt) forEachExpression(skill.interrupt->effects, visit);
  for (const auto& outcome : skill.successes) forEachExpression(outcome, visit);
  for (const auto& outcome : skill.failures) forEachExpression(outcome, visit);
  if (skill.body) forEachExpression(*skill.body, visit);
}

/// Calls `visit` for every condition and value of a program, and for each of their parts.
template <class Visit> void forEachExpression(const analysis::Program& program, Visit&& visit) {
  for (const auto& event : program.events.all) {
    if (event->guard) forEachPart(*event->guard, visit);
    forEachExpression(event->effects, visit);
  }
  for (const auto& skill : program.skills.all) forEachExpression(skill.node(), visit);
  for (const auto& environment : program.environments.all)
    forEachExpression(environment->body, visit);
  for (const auto& property : program.properties.all) {
    for (const auto& operand : property->operands) forEachPart(operand, visit);
    if (property->after) forEachPart(*property->after, visit);
    if (property->before) forEachPart(*property->before, visit);
  }
}

} // namespace proskill::codegen
