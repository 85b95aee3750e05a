#include "codegen/plan/mentions.h"

#include <algorithm>

namespace proskill::codegen {
namespace {

void collect(const fiacre::Expr& expr, Mentioned& found) {
  if (expr.kind == fiacre::ExprKind::Name) found.names.insert(expr.name);
  for (const auto& operand : expr.operands) collect(operand, found);
}

void collect(const fiacre::Statement& statement, Mentioned& found) {
  if (statement.kind == fiacre::StatementKind::Send ||
      statement.kind == fiacre::StatementKind::Receive)
    found.ports.insert(statement.name);
  for (const auto& target : statement.targets) collect(target, found);
  for (const auto& value : statement.values) collect(value, found);
  for (const auto& child : statement.children) collect(child, found);
}

} // namespace

bool mentions(const fiacre::Expr& expr, std::string_view variable) {
  return (expr.kind == fiacre::ExprKind::Name && expr.name == variable) ||
         std::ranges::any_of(expr.operands,
                             [&](const auto& part) { return mentions(part, variable); });
}

Mentioned mentionedIn(const fiacre::Process& process) {
  Mentioned found;
  for (const auto& from : process.transitions) collect(from.statement, found);
  return found;
}

} // namespace proskill::codegen
