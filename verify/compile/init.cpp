#include "verify/compile/init.h"

#include "verify/state/evaluate.h"
#include "verify/unsupported.h"

#include <algorithm>

namespace proskill::verify {

using fiacre::Statement;
using fiacre::StatementKind;

namespace {

constexpr int kMostInitTurns = 100'000;

} // namespace

std::int64_t firstValue(const System& system, NodeId node) {
  const Node& of = system.nodes[node];
  if (of.op == NodeOp::Number) return of.number;
  if (of.op == NodeOp::Cell) return system.cells[of.a].initial;
  std::vector<std::int64_t> first;
  first.reserve(system.cells.size());
  for (const auto& cell : system.cells) first.push_back(cell.initial);
  const auto value = evaluateUnpacked(system, node, first);
  if (!value) unsupported("a first value divides by zero");
  return *value;
}

void InitRunner::run(const Statement& init, const fiacre::Process* of, InstanceId id) {
  process = of;
  instance = id;
  step(init);
}

void InitRunner::step(const Statement& statement) {
  switch (statement.kind) {
  case StatementKind::Null:
  case StatementKind::Comment:
  case StatementKind::Tag: return;
  case StatementKind::Sequence:
    for (const auto& child : statement.children) step(child);
    return;
  case StatementKind::Assign: return assign(statement);
  case StatementKind::If: return chooseArm(statement);
  case StatementKind::Case: return chooseCase(statement);
  case StatementKind::While: return repeat(statement);
  case StatementKind::Foreach: return forEachValue(statement);
  case StatementKind::To: return enter(statement);
  case StatementKind::Any:
  case StatementKind::On:
  case StatementKind::Wait:
  case StatementKind::Loop:
  case StatementKind::Select:
  case StatementKind::Send:
  case StatementKind::Receive:
  case StatementKind::Start:
  case StatementKind::Sync:
  case StatementKind::Return:
    unsupported("a statement in `init` that is not verified yet", statement.origin);
  }
}

void InitRunner::enter(const Statement& statement) {
  if (!process) unsupported("a component has no states", statement.origin);
  const auto state = std::ranges::find(process->states, statement.name, &fiacre::State::name);
  if (state == process->states.end())
    unsupported("`" + statement.name + "` is not a state of this process", statement.origin);
  system.cells[system.instances[instance].location].initial = state - process->states.begin();
}

void InitRunner::assign(const Statement& statement) {
  std::vector<Assignment> assignments;
  for (std::size_t i = 0; i < statement.targets.size(); ++i) {
    const fiacre::Type& type = expressions.typeOf(statement.targets[i], scope);
    const Value source = expressions.value(statement.values.at(i), scope, &type);
    expressions.assign(statement.targets[i], source, scope, assignments, 0);
  }
  set(assignments);
}

/// Reads all values before it sets any.
void InitRunner::set(const std::vector<Assignment>& assignments) {
  std::vector<std::int64_t> values;
  for (const auto& assignment : assignments) values.push_back(firstValue(system, assignment.value));
  for (std::size_t i = 0; i < assignments.size(); ++i) {
    Cell& cell = system.cells[assignments[i].target];
    if (values[i] < cell.low || values[i] > cell.high)
      unsupported("`" + cell.name + "` starts outside of its range");
    cell.initial = values[i];
  }
}

void InitRunner::chooseArm(const Statement& statement) {
  const bool holds = firstValue(system, expressions.scalar(statement.values.at(0), scope)) != 0;
  if (holds || statement.children.size() > 1) step(statement.children[holds ? 0 : 1]);
}

void InitRunner::chooseCase(const Statement& statement) {
  const Value tested = expressions.value(statement.values.at(0), scope);
  for (std::size_t i = 0; i < statement.children.size(); ++i) {
    const auto& pattern = statement.values.at(i + 1);
    if (firstValue(system, expressions.matches(pattern, tested, scope)) == 0) continue;
    std::vector<Assignment> bound;
    for (const auto& [variable, value] : expressions.bindings(pattern, tested, scope))
      expressions.assign(variable, value, scope, bound, 0);
    set(bound);
    return step(statement.children[i]);
  }
  unsupported("no pattern of a `case` in `init` matches", statement.origin);
}

void InitRunner::repeat(const Statement& statement) {
  for (int turn = 0; turn < kMostInitTurns; ++turn) {
    if (firstValue(system, expressions.scalar(statement.values.at(0), scope)) == 0) return;
    step(statement.children.at(0));
  }
  unsupported("a `while` in `init` does not end", statement.origin);
}

void InitRunner::forEachValue(const Statement& statement) {
  const fiacre::Expr variable{.kind = fiacre::ExprKind::Name, .name = statement.name};
  const auto all = expressions.allValues(expressions.typeOf(variable, scope));
  for (auto value = all.low; value <= all.high; ++value) {
    assign(expressions.assignmentOf(variable, value));
    step(statement.children.at(0));
  }
}

} // namespace proskill::verify
