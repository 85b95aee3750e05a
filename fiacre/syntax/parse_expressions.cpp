#include "fiacre/syntax/parser.h"

#include "fiacre/syntax/words.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <utility>

namespace proskill::fiacre {
namespace {

using Operator = std::pair<std::string_view, Op>;

/// From the lowest precedence to the highest; all are left-associative.
const std::array<std::vector<Operator>, 6> kLevels{{
    {{"or", Op::Or}},
    {{"and", Op::And}},
    {{"=", Op::Equal}, {"<>", Op::NotEqual}},
    {{"<", Op::Less}, {">", Op::Greater}, {"<=", Op::LessEqual}, {">=", Op::GreaterEqual}},
    {{"+", Op::Add}, {"-", Op::Subtract}},
    {{"*", Op::Multiply}, {"/", Op::Divide}, {"%", Op::Modulo}},
}};

constexpr auto kPrefixes = std::to_array<Operator>({{"not", Op::Not},
                                                    {"-", Op::Negate},
                                                    {"$", Op::Coerce},
                                                    {"empty", Op::Empty},
                                                    {"full", Op::Full},
                                                    {"first", Op::First},
                                                    {"dequeue", Op::Dequeue}});

} // namespace

Expr Parser::expr() {
  const Deeper deeper(*this);
  Expr condition = binary(0);
  if (!accept("?")) return condition;
  Height height(*this);
  height.addPart();
  Expr result{.kind = ExprKind::Conditional};
  result.operands.push_back(std::move(condition));
  result.operands.push_back(expr());
  height.addPart();
  expect(":");
  result.operands.push_back(expr());
  height.addPart();
  height.addNode();
  return result;
}

Expr Parser::binary(std::size_t level) {
  if (level == kLevels.size()) return prefix();
  Expr left = binary(level + 1);
  Height height(*this);
  for (;;) {
    height.addPart();
    const Operator* found = nullptr;
    for (const auto& each : kLevels[level])
      if (isAt(each.first)) found = &each;
    if (!found) return left;
    ++at;
    Expr right = binary(level + 1);
    height.addPart();
    height.addNode();
    left = Expr{.kind = ExprKind::Binary,
                .op = found->second,
                .operands = operandsOf(std::move(left), std::move(right))};
  }
}

Expr Parser::prefix() {
  const Deeper deeper(*this);
  if (accept("+")) return prefix(); // a sign of a number, without effect
  for (const auto& [word, op] : kPrefixes) {
    if (!accept(word)) continue;
    Expr operand = prefix();
    Height height(*this);
    height.addPart();
    height.addNode();
    if (op == Op::Negate && operand.kind == ExprKind::Number && operand.number > 0) {
      operand.number = -operand.number;
      return operand;
    }
    return {.kind = ExprKind::Unary, .op = op, .operands = operandsOf(std::move(operand))};
  }
  return postfix();
}

Expr Parser::postfix() {
  Expr result = primary();
  Height height(*this);
  for (;; height.addNode()) {
    height.addPart();
    if (constantsOnly) return result;
    if (accept(".")) {
      result = Expr{.kind = ExprKind::Field,
                    .name = name("the name of a field", NameKind::Field),
                    .operands = operandsOf(std::move(result))};
    } else if (isAt("[") && !isAtPair("[", "]")) {
      ++at;
      Expr index = expr();
      expect("]");
      result = Expr{.kind = ExprKind::Index,
                    .operands = operandsOf(std::move(result), std::move(index))};
    } else {
      return result;
    }
  }
}

Expr Parser::primary() {
  height = 0;
  if (peek().kind == TokenKind::Number) return number();
  if (accept("true")) return {.kind = ExprKind::Bool, .number = 1};
  if (accept("false")) return {.kind = ExprKind::Bool, .number = 0};
  if (inPattern && accept("any")) return {.kind = ExprKind::Name, .name = "any"};
  if (accept("(")) return parenthesised();
  if (accept("{|")) return {.kind = ExprKind::Queue, .operands = exprs("|}")};
  if (accept("{")) return record();
  if (accept("[")) return {.kind = ExprKind::Array, .operands = exprs("]")};
  for (auto [word, op] : {Operator{"enqueue", Op::Enqueue}, Operator{"append", Op::Append}}) {
    if (!accept(word)) continue;
    expect("(");
    Expr result{.kind = ExprKind::Binary, .op = op, .operands = exprs(")")};
    if (result.operands.size() != 2) fail(fmt::format("`{}` takes a queue and an element", word));
    return result;
  }
  const auto callee = name("an expression", NameKind::Value);
  return isAt("(") ? call(callee) : Expr{.kind = ExprKind::Name, .name = callee};
}

Expr Parser::number() {
  const Token& token = peek();
  Expr result{.kind = ExprKind::Number};
  const auto read =
      std::from_chars(token.text.data(), token.text.data() + token.text.size(), result.number);
  if (read.ec != std::errc()) fail("number too large");
  ++at;
  return result;
}

Expr Parser::parenthesised() {
  Expr result = expr();
  expect(")");
  return result;
}

Expr Parser::record() {
  Expr result{.kind = ExprKind::Record};
  Height height(*this);
  do {
    result.fields.push_back(name("the name of a field", NameKind::Field));
    expect("=");
    result.operands.push_back(expr());
    height.addPart();
  } while (accept(","));
  expect("}");
  height.addNode();
  return result;
}

Expr Parser::call(const std::string& callee) {
  expect("(");
  return {.kind = ExprKind::Construct, .name = callee, .operands = exprs(")")};
}

/// The operands of a node, up to the closing sign; there may be none.
std::vector<Expr> Parser::exprs(std::string_view close) {
  if (accept(close)) return {};
  Height height(*this);
  auto all = list(",", [&] {
    Expr operand = expr();
    height.addPart();
    return operand;
  });
  expect(close);
  height.addNode();
  return all;
}

Expr Parser::lvalue() {
  Expr result = postfix();
  const Expr* root = &result;
  while (root->kind == ExprKind::Index || root->kind == ExprKind::Field)
    root = root->operands.data();
  if (root->kind != ExprKind::Name) fail("cannot be assigned to");
  return result;
}

std::optional<Expr> Parser::wholeExpr() {
  try {
    Expr result = expr();
    if (peek().kind != TokenKind::End) fail("unexpected text after the expression");
    if (parsed.problems.empty()) return result;
  } catch (const CannotRead&) {
    return std::nullopt;
  }
  return std::nullopt;
}

std::optional<Expr> parseExpr(std::string_view text) { return Parser(text).wholeExpr(); }

} // namespace proskill::fiacre
