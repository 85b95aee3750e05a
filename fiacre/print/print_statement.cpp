#include "fiacre/print/print_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace proskill::fiacre {
namespace {

/// Text after a statement: `;` if another one follows, otherwise empty.
using Suffix = std::string_view;

void print(Output& out, const Statement& statement, std::size_t indent, Suffix suffix);

bool isSilent(const Statement& statement) {
  if (statement.kind == StatementKind::Sequence)
    return std::ranges::all_of(statement.children, isSilent);
  return statement.kind == StatementKind::Comment;
}

/// Prints the body of a branch, one level deeper. Fiacre requires a statement even in an empty
/// branch.
void printBody(Output& out, const Statement& body, std::size_t indent) {
  print(out, body, indent + Writer::kStep, {});
}

std::string whereClause(const Statement& statement) {
  return statement.values.empty() ? "" : " where " + printOperand(statement.values[0]);
}

std::string withArguments(std::string_view name, std::string_view sign,
                          const std::vector<Expr>& values) {
  if (values.empty()) return std::string(name);
  std::vector<std::string> parts;
  for (const auto& value : values) parts.push_back(printOperand(value));
  return fmt::format("{} {} {}", name, sign, join(parts, ", "));
}

/// A statement that fits on one line.
std::string simpleText(const Statement& s) {
  switch (s.kind) {
  case StatementKind::Null: return "null";
  case StatementKind::Assign:
    return fmt::format("{} := {}", printList(s.targets), printList(s.values));
  case StatementKind::Any: return printList(s.targets) + " := any" + whereClause(s);
  case StatementKind::On: return "on " + printOperand(s.values[0]);
  case StatementKind::Wait: return "wait " + printInterval(s.interval);
  case StatementKind::To: return "to " + s.name;
  case StatementKind::Loop: return "loop";
  case StatementKind::Send: return withArguments(s.name, "!", s.values);
  case StatementKind::Receive: return withArguments(s.name, "?", s.targets) + whereClause(s);
  case StatementKind::Tag: return "#" + s.name;
  case StatementKind::Start: return fmt::format("start {}({})", s.name, printList(s.values));
  case StatementKind::Sync:
    return s.targets.empty() ? "sync " + s.name
                             : fmt::format("sync {} {}", s.name, printLvalue(s.targets[0]));
  case StatementKind::Return: return "return " + printExpr(s.values[0]);
  case StatementKind::Comment:
  case StatementKind::If:
  case StatementKind::Case:
  case StatementKind::Select:
  case StatementKind::Sequence:
  case StatementKind::While:
  case StatementKind::Foreach: assert(false); return {};
  }
  std::unreachable();
}

/// The `if` that is the whole else-part, to print `elsif`.
const Statement* nestedIf(const Statement& otherwise) {
  if (otherwise.kind == StatementKind::If) return &otherwise;
  const bool wrapped = otherwise.kind == StatementKind::Sequence &&
                       otherwise.children.size() == 1 && otherwise.comment.empty();
  return wrapped ? nestedIf(otherwise.children[0]) : nullptr;
}

void printArms(Output& out, const Statement& arm, std::size_t indent, std::string_view keyword) {
  out.writer.line(indent, fmt::format("{} {} then", keyword, printOperand(arm.values[0])),
                  arm.comment);
  printBody(out, arm.children[0], indent);
  if (arm.children.size() < 2) return;
  if (const auto* next = nestedIf(arm.children[1])) {
    Place place(out, next->origin);
    return printArms(out, *next, indent, "elsif");
  }
  out.writer.line(indent, "else");
  printBody(out, arm.children[1], indent);
}

void printIf(Output& out, const Statement& statement, std::size_t indent, Suffix suffix) {
  printArms(out, statement, indent, "if");
  out.writer.line(indent, fmt::format("end{}", suffix));
}

void printCase(Output& out, const Statement& s, std::size_t indent, Suffix suffix) {
  out.writer.line(indent, fmt::format("case {} of", printOperand(s.values[0])), s.comment);
  for (std::size_t i = 0; i < s.children.size(); ++i) {
    out.writer.line(indent,
                    fmt::format("{} {} ->", i == 0 ? " " : "|", printExpr(s.values[1 + i])));
    printBody(out, s.children[i], indent);
  }
  out.writer.line(indent, fmt::format("end{}", suffix));
}

void printSelect(Output& out, const Statement& s, std::size_t indent, Suffix suffix) {
  out.writer.line(indent, "select", s.comment);
  for (std::size_t i = 0; i < s.children.size(); ++i) {
    const bool unless = std::ranges::find(s.priorityGroups, i) != s.priorityGroups.end();
    if (i != 0) out.writer.line(indent, unless ? "unless" : "[]");
    printBody(out, s.children[i], indent);
  }
  out.writer.line(indent, fmt::format("end{}", suffix));
}

void printLoop(Output& out, const Statement& s, std::size_t indent, Suffix suffix) {
  const auto head = s.kind == StatementKind::While
                        ? fmt::format("while {} do", printOperand(s.values[0]))
                        : fmt::format("foreach {} do", s.name);
  out.writer.line(indent, head, s.comment);
  printBody(out, s.children[0], indent);
  out.writer.line(indent, fmt::format("end{}", suffix));
}

void printSilent(Output& out, const Statement& statement, std::size_t indent) {
  Place place(out, statement.origin);
  out.writer.comment(indent, statement.comment);
  for (const auto& child : statement.children) printSilent(out, child, indent);
}

/// Puts the suffix after the last statement that is not a comment.
void printSequence(Output& out, const Statement& s, std::size_t indent, Suffix suffix) {
  out.writer.comment(indent, s.comment);
  const auto& children = s.children;
  const auto last = std::find_if_not(children.rbegin(), children.rend(), isSilent).base();
  for (auto child = children.begin(); child != children.end(); ++child) {
    const bool followed = child + 1 < last;
    if (isSilent(*child))
      printSilent(out, *child, indent);
    else
      print(out, *child, indent, followed ? ";" : suffix);
  }
  if (last == children.begin()) out.writer.line(indent, fmt::format("null{}", suffix));
}

void print(Output& out, const Statement& s, std::size_t indent, Suffix suffix) {
  Place place(out, s.origin);
  switch (s.kind) {
  case StatementKind::If: return printIf(out, s, indent, suffix);
  case StatementKind::Case: return printCase(out, s, indent, suffix);
  case StatementKind::Select: return printSelect(out, s, indent, suffix);
  case StatementKind::While:
  case StatementKind::Foreach: return printLoop(out, s, indent, suffix);
  case StatementKind::Sequence: return printSequence(out, s, indent, suffix);
  case StatementKind::Comment:
    out.writer.comment(indent, s.comment);
    return out.writer.line(indent, fmt::format("null{}", suffix));
  case StatementKind::Null:
  case StatementKind::Assign:
  case StatementKind::Any:
  case StatementKind::On:
  case StatementKind::Wait:
  case StatementKind::To:
  case StatementKind::Loop:
  case StatementKind::Send:
  case StatementKind::Receive:
  case StatementKind::Tag:
  case StatementKind::Start:
  case StatementKind::Sync:
  case StatementKind::Return:
    return out.writer.line(indent, simpleText(s) + std::string(suffix), s.comment);
  }
}

} // namespace

void printStatement(Output& out, const Statement& statement, std::size_t indent) {
  print(out, statement, indent, {});
}

} // namespace proskill::fiacre
