#include "tests/support/oracle/canonical.h"

#include <algorithm>

namespace proskill::test {
namespace {

using namespace proskill::fiacre; // NOLINT: the tree's own words

void mend(Expr& expr);

/// The operands of a chain of `and` or of `or`, from the left.
void collect(Expr& expr, Op op, std::vector<Expr>& operands) {
  if (expr.kind != ExprKind::Binary || expr.op != op) {
    mend(expr);
    return operands.push_back(std::move(expr));
  }
  collect(expr.operands[0], op, operands);
  collect(expr.operands[1], op, operands);
}

void mend(Expr& expr) {
  if (expr.kind == ExprKind::Binary && (expr.op == Op::And || expr.op == Op::Or)) {
    std::vector<Expr> operands;
    const auto op = expr.op;
    collect(expr, op, operands);
    expr = operands[0];
    for (std::size_t i = 1; i < operands.size(); ++i)
      expr = Expr{.kind = ExprKind::Binary, .op = op, .operands = {expr, operands[i]}};
    return;
  }
  for (auto& operand : expr.operands) mend(operand);
  if (expr.kind == ExprKind::Unary && expr.op == Op::Negate &&
      expr.operands[0].kind == ExprKind::Number && expr.operands[0].number > 0)
    expr = Expr{.kind = ExprKind::Number, .number = -expr.operands[0].number};
}

void mend(Type& type) {
  for (auto& member : type.members) {
    member.comment.clear();
    for (auto& inner : member.type) mend(inner);
  }
  for (auto& element : type.element) mend(element);
}

void mend(Statement& statement);

void flatten(Statement& statement, std::vector<Statement>& all) {
  if (statement.kind == StatementKind::Comment) return;
  if (statement.kind == StatementKind::Sequence) {
    for (auto& child : statement.children) flatten(child, all);
    return;
  }
  mend(statement);
  all.push_back(std::move(statement));
}

void mend(Statement& statement) {
  statement.comment.clear();
  statement.origin = 0;
  for (auto& target : statement.targets) mend(target);
  for (auto& value : statement.values) mend(value);
  if (statement.kind == StatementKind::Comment) statement = {};
  if (statement.kind != StatementKind::Sequence) {
    for (auto& child : statement.children) mend(child);
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

void mend(std::vector<Variable>& variables) {
  for (auto& variable : variables) {
    variable.comment.clear();
    mend(variable.type);
    if (variable.init) mend(*variable.init);
  }
}

void mend(Observable& observable) {
  mend(observable.value);
  for (auto& operand : observable.operands) mend(operand);
}

void mend(std::vector<Port>& ports) {
  for (auto& port : ports) {
    port.comment.clear();
    port.origin = 0;
    if (port.probe) mend(*port.probe);
    for (auto& value : port.values) mend(value);
  }
}

void mend(Process& process) {
  process.comment.clear();
  process.origin = 0;
  mend(process.ports);
  mend(process.variables);
  for (auto& state : process.states) state.origin = 0;
  if (process.init) mend(*process.init);
  for (auto& from : process.transitions) {
    from.comment.clear();
    from.origin = 0;
    mend(from.statement);
  }
}

void mend(std::vector<Instance>& instances) {
  for (auto& instance : instances) {
    mend(instance.parts);
    instance.references.resize(instance.arguments.size());
    for (auto& argument : instance.arguments) mend(argument);
  }
}

void mend(Component& component) {
  component.comment.clear();
  mend(component.interfacePorts);
  mend(component.variables);
  mend(component.ports);
  if (component.init) mend(*component.init);
  mend(component.instances);
}

void mend(Property& property) {
  property.comment.clear();
  property.origin = 0;
  if (property.pattern.kind == PatternKind::DeadlockFree) property.pattern.operands.clear();
  for (auto& operand : property.pattern.operands) mend(operand);
}

} // namespace

Program canonical(Program program) {
  program.comment.clear();
  for (auto& constant : program.constants) mend(constant.value);
  for (auto& declared : program.types) {
    declared.comment.clear();
    mend(declared.type);
  }
  for (auto& event : program.eventPorts) event.port.comment.clear();
  for (auto& function : program.functions) {
    function.comment.clear();
    mend(function.variables);
    mend(function.body);
  }
  for (auto& process : program.processes) mend(process);
  for (auto& component : program.components) mend(component);
  for (auto& each : program.observers) each.origin = 0;
  std::erase_if(program.properties,
                [](const Property& it) { return it.pattern.kind == PatternKind::Progress; });
  for (auto& property : program.properties) mend(property);
  return program;
}

} // namespace proskill::test
