#include "analysis/flow/domain/numbers.h"

#include "analysis/names/walk.h"

namespace proskill::analysis::flow {

namespace {

using syntax::Effects;
using syntax::Expr;

class Collector {
public:
  void expr(const Expr& e) {
    if (auto number = wholeNumber(e)) found.push_back(*number);
    for (const Expr& operand : e.operands) expr(operand);
  }
  void effects(const Effects& effects) {
    for (const auto& effect : effects.items) expr(effect.value);
  }
  void body(const syntax::Block& block) {
    forEachStatement(block, [this](const syntax::Statement& statement) {
      expr(statement.condition);
      effects(statement.effects);
      for (const auto& arm : statement.arms)
        if (arm.condition) expr(*arm.condition);
    });
  }
  void outcomes(const syntax::List<syntax::Outcome>& outcomes) {
    for (const auto& outcome : outcomes) {
      effects(outcome.effects);
      if (outcome.postcondition) expr(*outcome.postcondition);
    }
  }
  void skill(const syntax::Skill& skill) {
    for (const auto& each : skill.preconditions) expr(each.condition);
    effects(skill.start);
    for (const auto& each : skill.invariants) expr(each.guard), effects(each.effects);
    if (skill.interrupt) effects(skill.interrupt->effects);
    outcomes(skill.successes);
    outcomes(skill.failures);
    if (skill.body) body(*skill.body);
  }

  std::vector<std::int64_t> found;
};

} // namespace

std::optional<std::int64_t> wholeNumber(const Expr& expr) {
  if (expr.kind != syntax::ExprKind::Number || expr.number.denominator != 1) return std::nullopt;
  return expr.number.numerator;
}

std::optional<std::int64_t> truthValue(const Expr& expr) {
  if (expr.kind == syntax::ExprKind::True) return 1;
  if (expr.kind == syntax::ExprKind::False) return 0;
  return std::nullopt;
}

std::vector<std::int64_t> numbersIn(const Program& program) {
  Collector collector;
  for (const auto& event : program.events.all) {
    if (event->guard) collector.expr(*event->guard);
    collector.effects(event->effects);
  }
  for (const auto& skill : program.skills.all) collector.skill(skill.node());
  for (const auto& environment : program.environments.all) collector.body(environment->body);
  return std::move(collector.found);
}

} // namespace proskill::analysis::flow
