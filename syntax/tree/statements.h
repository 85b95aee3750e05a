#pragma once

#include "syntax/tree/ast.h"

namespace proskill::syntax {

/// Calls `visit` on each statement of a block, outer before inner, in the order of the text.
template <class Visit> void forEachStatement(const Block& block, Visit&& visit) {
  for (const Statement& statement : block.statements) {
    visit(statement);
    for (const Arm& arm : statement.arms) forEachStatement(arm.body, visit);
    for (const Block& branch : statement.branches) forEachStatement(branch, visit);
  }
}

} // namespace proskill::syntax
