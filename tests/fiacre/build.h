#pragma once

#include "fiacre/syntax/tree.h"

#include <string>
#include <utility>
#include <vector>

/// Short names for building trees.
namespace proskill::fiacre::test {

inline Expr name(std::string text) { return {.kind = ExprKind::Name, .name = std::move(text)}; }
inline Expr number(std::int64_t value) { return {.kind = ExprKind::Number, .number = value}; }
inline Expr truth(bool value) { return {.kind = ExprKind::Bool, .number = value}; }
inline Expr unary(Op op, Expr operand) {
  return {.kind = ExprKind::Unary, .op = op, .operands = {std::move(operand)}};
}
inline Expr binary(Op op, Expr left, Expr right) {
  return {.kind = ExprKind::Binary, .op = op, .operands = {std::move(left), std::move(right)}};
}
inline Expr field(Expr record, std::string member) {
  return {.kind = ExprKind::Field, .name = std::move(member), .operands = {std::move(record)}};
}
inline Expr index(Expr array, Expr at) {
  return {.kind = ExprKind::Index, .operands = {std::move(array), std::move(at)}};
}
inline Expr call(std::string function, std::vector<Expr> arguments) {
  return {
      .kind = ExprKind::Construct, .name = std::move(function), .operands = std::move(arguments)};
}

inline Statement null() { return {}; }
inline Statement comment(std::string text) {
  return {.kind = StatementKind::Comment, .comment = std::move(text)};
}
inline Statement assign(Expr target, Expr value) {
  return {
      .kind = StatementKind::Assign, .targets = {std::move(target)}, .values = {std::move(value)}};
}
inline Statement on(Expr guard) {
  return {.kind = StatementKind::On, .values = {std::move(guard)}};
}
inline Statement wait(std::int64_t lower, std::optional<std::int64_t> upper) {
  return {.kind = StatementKind::Wait, .interval = {.lower = lower, .upper = upper}};
}
inline Statement to(std::string state) {
  return {.kind = StatementKind::To, .name = std::move(state)};
}
inline Statement port(std::string name) {
  return {.kind = StatementKind::Send, .name = std::move(name)};
}
inline Statement tag(std::string name) {
  return {.kind = StatementKind::Tag, .name = std::move(name)};
}
inline Statement sequence(std::vector<Statement> children) {
  return {.kind = StatementKind::Sequence, .children = std::move(children)};
}
inline Statement select(std::vector<Statement> children) {
  return {.kind = StatementKind::Select, .children = std::move(children)};
}
inline Statement ifThen(Expr condition, Statement then) {
  return {
      .kind = StatementKind::If, .values = {std::move(condition)}, .children = {std::move(then)}};
}
inline Statement ifElse(Expr condition, Statement then, Statement otherwise) {
  return {.kind = StatementKind::If,
          .values = {std::move(condition)},
          .children = {std::move(then), std::move(otherwise)}};
}
/// The statement with a comment.
inline Statement with(std::string text, Statement statement) {
  statement.comment = std::move(text);
  return statement;
}

inline Type boolean() { return {}; }
inline Type nat() { return {.kind = TypeKind::Nat}; }
inline Type range(std::int64_t low, std::int64_t high) {
  return {.kind = TypeKind::Range, .low = low, .high = high};
}
inline Type named(std::string text) { return {.kind = TypeKind::Named, .name = std::move(text)}; }
inline Type array(std::int64_t size, Type element) {
  return {.kind = TypeKind::Array, .size = size, .element = {std::move(element)}};
}
inline Type queue(std::int64_t size, Type element) {
  return {.kind = TypeKind::Queue, .size = size, .element = {std::move(element)}};
}
inline Type unionOf(std::vector<std::string> constructors) {
  Type type{.kind = TypeKind::Union};
  for (auto& constructor : constructors) type.members.push_back({std::move(constructor), {}, {}});
  return type;
}
inline Type record(std::vector<std::pair<std::string, Type>> fields) {
  Type type{.kind = TypeKind::Record};
  for (auto& [label, value] : fields) type.members.push_back({label, {value}, {}});
  return type;
}

inline Process process(std::string text, std::vector<std::string> states,
                       std::vector<From> transitions) {
  Process made{.name = std::move(text), .transitions = std::move(transitions)};
  for (auto& state : states) made.states.push_back({std::move(state)});
  return made;
}
inline From from(std::string state, std::vector<Statement> statements) {
  return {std::move(state), sequence(std::move(statements)), {}};
}

/// The triple click detector, with its 0.2 s as 2 units.
Program tripleClick();

} // namespace proskill::fiacre::test
