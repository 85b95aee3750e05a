#pragma once

#include "syntax/tree/ast.h"

namespace proskill::syntax {

/// Calls `visit` for each statement of a block, outer before inner, in the order of the text.
template <class Visit> void forEachStatement(const Block& block, Visit&& visit) {
  for (const Statement& statement : block.statements) {
    visit(statement);
    for (const Block& branch : statement.branches) forEachStatement(branch, visit);
    for (const Arm& arm : statement.arms) forEachStatement(arm.body, visit);
  }
}

/// Whether its branches run in parallel.
[[nodiscard]] inline bool runsBranches(const Statement& statement) {
  return statement.kind == StatementKind::Parallel || statement.kind == StatementKind::Race;
}

/// Whether it is a wait for a condition that ends after `duration` with the statements of
/// `branches[0]`.
[[nodiscard]] inline bool hasTimeout(const Statement& statement) {
  return statement.kind == StatementKind::WaitCondition && !statement.branches.empty();
}

/// Whether it waits for `duration`, or at most for this time.
[[nodiscard]] inline bool hasDuration(const Statement& statement) {
  return statement.kind == StatementKind::WaitTime || hasTimeout(statement);
}

/// The call of a `case`; null if it is missing.
[[nodiscard]] inline const Statement* callOf(const Statement& statement) {
  if (statement.kind != StatementKind::Case || statement.branches[0].statements.empty())
    return nullptr;
  return &statement.branches[0].statements[0];
}

} // namespace proskill::syntax
