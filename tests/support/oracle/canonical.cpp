#include "tests/support/oracle/canonical.h"

#include <algorithm>

namespace proskill::test {
namespace {

using namespace proskill::fiacre; // NOLINT: the tree's own words

void canonicalise(Expr& expr);

/// The operands of a chain of `and` or of `or`, from the left.
void collect(Expr& expr, Op op, std::vector<Expr>& operands) {
  if (expr.kind != ExprKind::Binary || expr.op != op) {
    canonicalise(expr);
    return operands.push_back(std::move(expr));
  }
  collect(expr.operands[0], op, operands);
  collect(expr.operands[1], op, operands);
}

void canonicalise(Expr& expr) {
  if (expr.kind == ExprKind::Binary && (expr.op == Op::And || expr.op == Op::Or)) {
    std::vector<Expr> operands;
    const auto op = expr.op;
    collect(expr, op, operands);
    expr = operands[0];
    for (std::size_t i = 1; i < operands.size(); ++i)
      expr = Expr{.kind = ExprKind::Binary, .op = op, .operands = {expr, operands[i]}};
    return;
  }
  for (auto& operand : expr.operands) canonicalise(operand);
  if (expr.kind == ExprKind::Unary && expr.op == Op::Negate &&
      expr.operands[0].kind == ExprKind::Number && expr.operands[0].number > 0)
    expr = Expr{.kind = ExprKind::Number, .number = -expr.operands[0].number};
}

void canonicalise(Type& type) {
  for (auto& member : type.members) {
    member.comment.clear();
    for (auto& inner : member.type) canonicalise(inner);
  }
  for (auto& element : type.element) canonicalise(element);
}

void canonicalise(Statement& statement);

void flatten(Statement& statement, std::vector<Statement>& all) {
  if (statement.kind == StatementKind::Comment) return;
  if (statement.kind == StatementKind::Sequence) {
    for (auto& child : statement.children) flatten(child, all);
    return;
  }
  canonicalise(statement);
  all.push_back(std::move(statement));
}

void canonicalise(Statement& statement) {
  statement.comment.clear();
  statement.origin = 0;
  for (auto& target : statement.targets) canonicalise(target);
  for (auto& value : statement.values) canonicalise(value);
  if (statement.kind == StatementKind::Comment) statement = {};
  if (statement.kind != StatementKind::Sequence) {
    for (auto& child : statement.children) canonicalise(child);
    return;
  }
  std::vector<Statement> all;
  flatten(statement, all);
  if (all.empty()) all.push_back({});
  if (all.size() == 1)
    statement = Statement(all[0]);
  else
    statement.children = std::move(all);
}

void canonicalise(std::vector<Variable>& variables) {
  for (auto& variable : variables) {
    variable.comment.clear();
    canonicalise(variable.type);
    if (variable.init) canonicalise(*variable.init);
  }
}

void canonicalise(Observable& observable) {
  canonicalise(observable.value);
  for (auto& operand : observable.operands) canonicalise(operand);
}

void canonicalise(std::vector<Port>& ports) {
  for (auto& port : ports) {
    port.comment.clear();
    port.origin = 0;
    if (port.probe) canonicalise(*port.probe);
    for (auto& value : port.values) canonicalise(value);
  }
}

void canonicalise(Process& process) {
  process.comment.clear();
  process.origin = 0;
  canonicalise(process.ports);
  canonicalise(process.variables);
  for (auto& state : process.states) state.origin = 0;
  if (process.init) canonicalise(*process.init);
  for (auto& from : process.transitions) {
    from.comment.clear();
    from.origin = 0;
    canonicalise(from.statement);
  }
}

void canonicalise(std::vector<Instance>& instances) {
  for (auto& instance : instances) {
    canonicalise(instance.parts);
    instance.references.resize(instance.arguments.size());
    for (auto& argument : instance.arguments) canonicalise(argument);
  }
}

void canonicalise(Component& component) {
  component.comment.clear();
  canonicalise(component.interfacePorts);
  canonicalise(component.variables);
  canonicalise(component.ports);
  if (component.init) canonicalise(*component.init);
  canonicalise(component.instances);
}

void canonicalise(Property& property) {
  property.comment.clear();
  property.origin = 0;
  if (property.pattern.kind == PatternKind::DeadlockFree) property.pattern.operands.clear();
  for (auto& operand : property.pattern.operands) canonicalise(operand);
}

} // namespace

Program canonical(Program program) {
  program.comment.clear();
  for (auto& constant : program.constants) canonicalise(constant.value);
  for (auto& declared : program.types) {
    declared.comment.clear();
    canonicalise(declared.type);
  }
  for (auto& event : program.eventPorts) event.port.comment.clear();
  for (auto& function : program.functions) {
    function.comment.clear();
    canonicalise(function.variables);
    canonicalise(function.body);
  }
  for (auto& process : program.processes) canonicalise(process);
  for (auto& component : program.components) canonicalise(component);
  for (auto& each : program.observers) each.origin = 0;
  std::erase_if(program.properties,
                [](const Property& it) { return it.pattern.kind == PatternKind::Progress; });
  for (auto& property : program.properties) canonicalise(property);
  return program;
}

} // namespace proskill::test
