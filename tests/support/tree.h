#pragma once

#include "fiacre/tree.h"

#include <utility>

/// Short words for Fiacre trees, for tests that build them by hand or by chance.
namespace proskill::test {

using fiacre::Expr;
using fiacre::Observable;
using fiacre::Statement;
using fiacre::Type;

inline Expr number(std::int64_t value) {
  Expr expr;
  expr.kind = fiacre::ExprKind::Number;
  expr.number = value;
  return expr;
}

inline Expr boolean(bool value) {
  Expr expr;
  expr.number = value;
  return expr;
}

inline Expr name(std::string text) {
  Expr expr;
  expr.kind = fiacre::ExprKind::Name;
  expr.name = std::move(text);
  return expr;
}

inline Expr binary(fiacre::Op op, Expr left, Expr right) {
  Expr expr;
  expr.kind = fiacre::ExprKind::Binary;
  expr.op = op;
  expr.operands = {std::move(left), std::move(right)};
  return expr;
}

inline Expr negation(Expr operand) {
  Expr expr;
  expr.kind = fiacre::ExprKind::Unary;
  expr.op = fiacre::Op::Not;
  expr.operands = {std::move(operand)};
  return expr;
}

inline Expr conditional(Expr test, Expr yes, Expr no) {
  Expr expr;
  expr.kind = fiacre::ExprKind::Conditional;
  expr.operands = {std::move(test), std::move(yes), std::move(no)};
  return expr;
}

inline Statement statement(fiacre::StatementKind kind, std::string text = {}) {
  Statement result;
  result.kind = kind;
  result.name = std::move(text);
  return result;
}

inline Statement with(fiacre::StatementKind kind, Expr value) {
  Statement result = statement(kind);
  result.values = {std::move(value)};
  return result;
}

inline Statement assign(Expr target, Expr value) {
  Statement result = with(fiacre::StatementKind::Assign, std::move(value));
  result.targets = {std::move(target)};
  return result;
}

inline Statement block(fiacre::StatementKind kind, std::vector<Statement> children) {
  Statement result = statement(kind);
  result.children = std::move(children);
  return result;
}

inline Type plain(fiacre::TypeKind kind) {
  Type type;
  type.kind = kind;
  return type;
}

inline Type range(std::int64_t low, std::int64_t high) {
  Type type = plain(fiacre::TypeKind::Range);
  type.low = low;
  type.high = high;
  return type;
}

inline Type named(std::string text) {
  Type type = plain(fiacre::TypeKind::Named);
  type.name = std::move(text);
  return type;
}

inline fiacre::Member member(std::string text, std::vector<Type> type = {}) {
  return {std::move(text), std::move(type), {}};
}

inline Observable stateOf(std::uint32_t instance, std::string state) {
  Observable observable;
  observable.path = {instance};
  observable.name = std::move(state);
  return observable;
}

} // namespace proskill::test
