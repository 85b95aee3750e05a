#include "fiacre/syntax/parser.h"

#include "fiacre/syntax/words.h"

#include <fmt/format.h>

#include <utility>

namespace proskill::fiacre {

/// Reads a sequence; a single statement is returned as it is.
Statement Parser::statements() {
  const Deeper deeper(*this);
  const auto begin = peek().begin;
  auto all = list(";", [&] { return statement(); });
  while (isAt("to") || isAt("loop")) {
    report(fmt::format("`;` is missing before `{}`", peek().text), peek());
    all.push_back(statement());
  }
  if (all.size() == 1) return std::move(all[0]);
  Statement result{.kind = StatementKind::Sequence, .children = std::move(all)};
  result.origin = origin(begin);
  return result;
}

Statement Parser::statement() {
  const auto begin = peek().begin;
  Statement result = plain();
  const bool simple = result.children.empty();
  result.origin =
      origin(begin, simple ? std::string(text.substr(begin, lastEnd() - begin)) : std::string());
  return result;
}

Statement Parser::plain() {
  if (accept("null")) return {.kind = StatementKind::Null};
  if (accept("loop")) return {.kind = StatementKind::Loop};
  if (accept("to"))
    return {.kind = StatementKind::To, .name = name("the name of a state", NameKind::State)};
  if (accept("wait")) return {.kind = StatementKind::Wait, .interval = interval()};
  if (accept("on")) return {.kind = StatementKind::On, .values = {expr()}};
  if (accept("return")) return {.kind = StatementKind::Return, .values = {expr()}};
  if (accept("#"))
    return {.kind = StatementKind::Tag, .name = name("the name of a tag", NameKind::Tag, true)};
  if (accept("if")) return conditional();
  if (accept("case")) return cases();
  if (accept("select")) return selection();
  if (isAt("while") || isAt("foreach")) return loop();
  if (isAtStart()) return startTask();
  if (accept("sync")) {
    Statement result{.kind = StatementKind::Sync,
                     .name = name("the name of a task", NameKind::Task)};
    if (isAtName()) result.targets.push_back(lvalue());
    return result;
  }
  if (isAtAssignedPattern()) return patternAssignment();
  if (!isAtName()) fail("a statement is missing");
  return startingWithName();
}

/// Whether a literal, or a constructor with its value, is next: the pattern on the left of `:=`.
bool Parser::isAtAssignedPattern() const {
  const bool isLiteral =
      isAt("true") || isAt("false") || isAt("any") || isAt("-") || peek().kind == TokenKind::Number;
  return isLiteral || (isAtName() && isAt("(", 1));
}

/// `pattern := value` goes on only if the value matches, like `case value of pattern -> null end`.
Statement Parser::patternAssignment() {
  const Expr pattern = matched();
  expect(":=");
  return {.kind = StatementKind::Case,
          .values = {expr(), pattern},
          .children = {{.kind = StatementKind::Null}}};
}

Expr Parser::matched() {
  const bool before = std::exchange(inPattern, true);
  Expr result = expr();
  inPattern = before;
  return result;
}

/// Reads an assignment or a communication.
Statement Parser::startingWithName() {
  if (isAt("!", 1) || isAt("?", 1)) {
    Statement result{.name = name("a port", NameKind::Port)};
    result.kind = isAt("!") ? StatementKind::Send : StatementKind::Receive;
    ++at;
    if (result.kind == StatementKind::Send) {
      result.values = list(",", [&] { return expr(); });
      return result;
    }
    result.targets = list(",", [&] { return isAt("any") ? matched() : lvalue(); });
    if (accept("where")) result.values.push_back(expr());
    return result;
  }
  auto targets = list(",", [&] { return lvalue(); });
  if (isAt(":=")) return assignment(std::move(targets));
  if (targets.size() == 1 && targets[0].kind == ExprKind::Name)
    return {.kind = StatementKind::Send, .name = targets[0].name};
  fail("`:=` is missing");
}

Statement Parser::assignment(std::vector<Expr> targets) {
  expect(":=");
  Statement result{.kind = StatementKind::Assign, .targets = std::move(targets)};
  if (!accept("any")) {
    result.values = list(",", [&] { return expr(); });
    return result;
  }
  result.kind = StatementKind::Any;
  if (accept("where")) result.values.push_back(expr());
  return result;
}

/// Reads a conditional after `if` or `elsif`.
Statement Parser::conditional() {
  const Deeper deeper(*this);
  Statement result{.kind = StatementKind::If, .values = {expr()}};
  expect("then");
  result.children.push_back(statements());
  const auto begin = peek().begin;
  if (accept("elsif")) {
    result.children.push_back(conditional());
    result.children.back().origin = origin(begin);
    return result;
  }
  if (accept("else")) result.children.push_back(statements());
  expect("end");
  accept("if");
  return result;
}

Statement Parser::cases() {
  Statement result{.kind = StatementKind::Case, .values = {expr()}};
  expect("of");
  do {
    result.values.push_back(matched());
    expect("->");
    result.children.push_back(statements());
  } while (accept("|"));
  expect("end");
  accept("case");
  return result;
}

Statement Parser::selection() {
  Statement result{.kind = StatementKind::Select};
  for (;;) {
    result.children.push_back(statements());
    if (isAtPair("[", "]")) {
      at += 2;
    } else if (accept("unless")) {
      result.priorityGroups.push_back(result.children.size());
    } else {
      expect("end");
      accept("select");
      return result;
    }
  }
}

Statement Parser::loop() {
  Statement result{.kind = StatementKind::While};
  if (accept("while")) {
    result.values.push_back(expr());
  } else {
    expect("foreach");
    result.kind = StatementKind::Foreach;
    result.name = name("the name of a variable", NameKind::Value);
  }
  expect("do");
  result.children.push_back(statements());
  expect("end");
  accept(result.kind == StatementKind::While ? "while" : "foreach");
  return result;
}

/// `start` is also a name: of a port, or of a variable.
bool Parser::isAtStart() const {
  return isAt("start") && peek(1).kind == TokenKind::Name && !isKeyword(peek(1).text);
}

Statement Parser::startTask() {
  expect("start");
  Statement result{.kind = StatementKind::Start,
                   .name = name("the name of a task", NameKind::Task)};
  expect("(");
  result.values = exprs(")");
  return result;
}

} // namespace proskill::fiacre
