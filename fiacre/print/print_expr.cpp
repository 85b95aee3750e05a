#include "fiacre/print/print.h"
#include "fiacre/print/print_parts.h"

#include <fmt/format.h>

#include <cassert>

namespace proskill::fiacre {
namespace {

std::string_view word(Op op) {
  switch (op) {
  case Op::Not: return "not";
  case Op::Negate: return "-";
  case Op::Coerce: return "$";
  case Op::Empty: return "empty";
  case Op::Full: return "full";
  case Op::First: return "first";
  case Op::Dequeue: return "dequeue";
  case Op::And: return "and";
  case Op::Or: return "or";
  case Op::Equal: return "=";
  case Op::NotEqual: return "<>";
  case Op::Less: return "<";
  case Op::LessEqual: return "<=";
  case Op::Greater: return ">";
  case Op::GreaterEqual: return ">=";
  case Op::Add: return "+";
  case Op::Subtract: return "-";
  case Op::Multiply: return "*";
  case Op::Divide: return "/";
  case Op::Modulo: return "%";
  case Op::Enqueue: return "enqueue";
  case Op::Append: return "append";
  }
  assert(false);
  return {};
}

bool isCompound(const Expr& expr) {
  if (expr.kind == ExprKind::Number) return expr.number < 0;
  if (expr.kind == ExprKind::Unary) return expr.op != Op::Coerce;
  return expr.kind == ExprKind::Binary && expr.op != Op::Enqueue && expr.op != Op::Append;
}

/// Prints nested `and` or `or` as one chain: both are associative.
void printChain(const Expr& expr, Op op, std::string& out) {
  if (expr.kind == ExprKind::Binary && expr.op == op) {
    printChain(expr.operands[0], op, out);
    printChain(expr.operands[1], op, out);
    return;
  }
  if (!out.empty()) out += fmt::format(" {} ", word(op));
  out += printOperand(expr);
}

std::string printBinary(const Expr& expr) {
  if (expr.op == Op::Enqueue || expr.op == Op::Append)
    return fmt::format("{}({})", word(expr.op), printList(expr.operands));
  std::string out;
  if (expr.op == Op::And || expr.op == Op::Or) {
    printChain(expr, expr.op, out);
    return out;
  }
  return fmt::format("{} {} {}", printOperand(expr.operands[0]), word(expr.op),
                     printOperand(expr.operands[1]));
}

std::string printUnary(const Expr& expr) {
  if (expr.op == Op::Coerce) return fmt::format("$({})", printExpr(expr.operands[0]));
  const auto* space = expr.op == Op::Negate ? "" : " ";
  return fmt::format("{}{}{}", word(expr.op), space, printOperand(expr.operands[0]));
}

std::string printRecord(const Expr& expr) {
  std::string out;
  for (std::size_t i = 0; i < expr.operands.size(); ++i)
    out += fmt::format("{}{}={}", i == 0 ? "" : ", ", expr.fields[i], printExpr(expr.operands[i]));
  return "{" + out + "}";
}

} // namespace

std::string printOperand(const Expr& expr) {
  return isCompound(expr) ? "(" + printExpr(expr) + ")" : printExpr(expr);
}

std::string printList(const std::vector<Expr>& exprs) {
  std::string out;
  for (const auto& expr : exprs) out += (out.empty() ? "" : ", ") + printExpr(expr);
  return out;
}

std::string printExpr(const Expr& expr) {
  switch (expr.kind) {
  case ExprKind::Bool: return expr.number != 0 ? "true" : "false";
  case ExprKind::Number: return fmt::to_string(expr.number);
  case ExprKind::Name: return expr.name;
  case ExprKind::Construct: return fmt::format("{}({})", expr.name, printList(expr.operands));
  case ExprKind::Unary: return printUnary(expr);
  case ExprKind::Binary: return printBinary(expr);
  case ExprKind::Conditional:
    return fmt::format("({} ? {} : {})", printOperand(expr.operands[0]),
                       printOperand(expr.operands[1]), printOperand(expr.operands[2]));
  case ExprKind::Index:
    return fmt::format("{}[{}]", printOperand(expr.operands[0]), printExpr(expr.operands[1]));
  case ExprKind::Field: return fmt::format("{}.{}", printOperand(expr.operands[0]), expr.name);
  case ExprKind::Array: return fmt::format("[{}]", printList(expr.operands));
  case ExprKind::Record: return printRecord(expr);
  case ExprKind::Queue: return fmt::format("{{|{}|}}", printList(expr.operands));
  }
  assert(false);
  return {};
}

std::string printLvalue(const Expr& lvalue) { return printExpr(lvalue); }

} // namespace proskill::fiacre
