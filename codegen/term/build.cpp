#include "codegen/term/build.h"

#include <cassert>
#include <utility>

namespace proskill::codegen {

using fiacre::Expr;
using fiacre::ExprKind;
using fiacre::Op;
using fiacre::Statement;
using fiacre::StatementKind;

namespace {

Statement make(StatementKind kind) {
  Statement statement;
  statement.kind = kind;
  return statement;
}

/// `a op b op c`, or `unit` without operands. An operand equal to `zero` is the whole result.
Expr chain(Op op, std::vector<Expr> operands, bool unit) {
  Expr result = boolean(unit);
  for (auto& operand : operands) {
    if (operand == boolean(unit)) continue;
    if (operand == boolean(!unit)) return operand;
    result = result == boolean(unit) ? std::move(operand)
                                     : binary(op, std::move(result), std::move(operand));
  }
  return result;
}

bool isEmpty(const Statement& statement) {
  return statement.kind == StatementKind::Sequence && statement.children.empty();
}

} // namespace

Expr boolean(bool value) {
  Expr expr;
  expr.kind = ExprKind::Bool;
  expr.number = value ? 1 : 0;
  return expr;
}

Expr number(std::int64_t value) {
  Expr expr;
  expr.kind = ExprKind::Number;
  expr.number = value;
  return expr;
}

Expr name(std::string_view text) {
  Expr expr;
  expr.kind = ExprKind::Name;
  expr.name = text;
  return expr;
}

Expr call(std::string_view function, std::vector<Expr> arguments) {
  Expr expr;
  expr.kind = ExprKind::Construct;
  expr.name = function;
  expr.operands = std::move(arguments);
  return expr;
}

Expr binary(Op op, Expr left, Expr right) {
  Expr expr;
  expr.kind = ExprKind::Binary;
  expr.op = op;
  expr.operands.push_back(std::move(left));
  expr.operands.push_back(std::move(right));
  return expr;
}

Expr equal(Expr left, Expr right) { return binary(Op::Equal, std::move(left), std::move(right)); }

Expr negation(Expr operand) {
  if (operand.kind == ExprKind::Bool) return boolean(operand.number == 0);
  if (operand.kind == ExprKind::Unary && operand.op == Op::Not)
    return std::move(operand.operands[0]);
  Expr expr;
  expr.kind = ExprKind::Unary;
  expr.op = Op::Not;
  expr.operands.push_back(std::move(operand));
  return expr;
}

Expr conjunction(std::vector<Expr> operands) { return chain(Op::And, std::move(operands), true); }
Expr disjunction(std::vector<Expr> operands) { return chain(Op::Or, std::move(operands), false); }

Expr conditional(Expr condition, Expr then, Expr otherwise) {
  if (isTrue(condition)) return then;
  if (isFalse(condition)) return otherwise;
  Expr expr;
  expr.kind = ExprKind::Conditional;
  expr.operands.push_back(std::move(condition));
  expr.operands.push_back(std::move(then));
  expr.operands.push_back(std::move(otherwise));
  return expr;
}

Expr element(Expr array, Expr index) {
  Expr expr;
  expr.kind = ExprKind::Index;
  expr.operands.push_back(std::move(array));
  expr.operands.push_back(std::move(index));
  return expr;
}

Expr field(Expr record, std::string_view name) {
  Expr expr;
  expr.kind = ExprKind::Field;
  expr.name = name;
  expr.operands.push_back(std::move(record));
  return expr;
}

bool isTrue(const Expr& expr) { return expr.kind == ExprKind::Bool && expr.number != 0; }
bool isFalse(const Expr& expr) { return expr.kind == ExprKind::Bool && expr.number == 0; }

Statement assign(Expr target, Expr value) {
  auto statement = make(StatementKind::Assign);
  statement.targets.push_back(std::move(target));
  statement.values.push_back(std::move(value));
  return statement;
}

Statement on(Expr condition) {
  if (isTrue(condition)) return sequence({});
  auto statement = make(StatementKind::On);
  statement.values.push_back(std::move(condition));
  return statement;
}

Statement wait(fiacre::Interval interval) {
  auto statement = make(StatementKind::Wait);
  statement.interval = interval;
  return statement;
}

Statement atOnce() { return wait({.lower = 0, .upper = 0}); }

Statement to(std::string_view state) {
  auto statement = make(StatementKind::To);
  statement.name = state;
  return statement;
}

Statement stay() { return make(StatementKind::Loop); }

Statement tag(std::string_view name) {
  auto statement = make(StatementKind::Tag);
  statement.name = name;
  return statement;
}

Statement synchronise(std::string_view port) {
  auto statement = make(StatementKind::Send);
  statement.name = port;
  return statement;
}

Statement comment(std::string text) {
  auto statement = make(StatementKind::Comment);
  statement.comment = std::move(text);
  return statement;
}

Statement ifThen(Expr condition, Statement then) {
  if (isTrue(condition)) return then;
  if (isFalse(condition)) return sequence({});
  auto statement = make(StatementKind::If);
  statement.values.push_back(std::move(condition));
  statement.children.push_back(std::move(then));
  return statement;
}

Statement ifThenElse(Expr condition, Statement then, Statement otherwise) {
  if (isTrue(condition)) return then;
  if (isFalse(condition)) return otherwise;
  auto statement = ifThen(std::move(condition), std::move(then));
  if (!isEmpty(otherwise)) statement.children.push_back(std::move(otherwise));
  return statement;
}

Statement select(std::vector<Statement> alternatives) {
  assert(!alternatives.empty());
  if (alternatives.size() == 1) return std::move(alternatives[0]);
  auto statement = make(StatementKind::Select);
  statement.children = std::move(alternatives);
  return statement;
}

Statement sequence(std::vector<Statement> statements) {
  auto result = make(StatementKind::Sequence);
  for (auto& statement : statements) {
    const bool plain = statement.kind == StatementKind::Sequence && statement.origin == 0 &&
                       statement.comment.empty();
    if (!plain)
      result.children.push_back(std::move(statement));
    else
      for (auto& child : statement.children) result.children.push_back(std::move(child));
  }
  return result;
}

Statement at(OriginId origin, Statement statement) {
  statement.origin = origin;
  return statement;
}

Statement saying(std::string words, Statement statement) {
  statement.comment = std::move(words);
  return statement;
}

fiacre::Type namedType(std::string_view name) {
  fiacre::Type type;
  type.kind = fiacre::TypeKind::Named;
  type.name = name;
  return type;
}

fiacre::Type rangeType(std::int64_t low, std::int64_t high) {
  fiacre::Type type;
  type.kind = fiacre::TypeKind::Range;
  type.low = low;
  type.high = high;
  return type;
}

fiacre::Type boolType() { return {}; }

} // namespace proskill::codegen
