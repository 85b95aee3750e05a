#pragma once

#include "syntax/tree/ast.h"

namespace proskill::syntax {

/// Calls `visit` on each statement of a block, outer before inner, in the order of the text.
template <class Visit> void forEachStatement(const Block& block, Visit&& visit) {
  for (const Statement& statement : block.statements) {
    visit(statement);
    for (const Block& branch : statement.branches) forEachStatement(branch, visit);
    for (const Arm& arm : statement.arms) forEachStatement(arm.body, visit);
  }
}

/// Its branches run at the same time.
[[nodiscard]] inline bool runsBranches(const Statement& statement) {
  return statement.kind == StatementKind::Parallel || statement.kind == StatementKind::Race;
}

/// A wait for a condition that ends after its `duration`, with the statements of `branches[0]`.
[[nodiscard]] inline bool hasTimeout(const Statement& statement) {
  return statement.kind == StatementKind::WaitCondition && !statement.branches.empty();
}

/// It waits for its `duration`, or at most so long.
[[nodiscard]] inline bool hasDuration(const Statement& statement) {
  return statement.kind == StatementKind::WaitTime || hasTimeout(statement);
}

/// The call of a `case`; null where it is missing.
[[nodiscard]] inline const Statement* callOf(const Statement& statement) {
  if (statement.kind != StatementKind::Case || statement.branches[0].statements.empty())
    return nullptr;
  return &statement.branches[0].statements[0];
}

} // namespace proskill::syntax
