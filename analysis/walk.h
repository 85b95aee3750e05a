#pragma once

#include "analysis/symbols.h"

/// Walks over bodies, for whoever looks for one kind of statement and does not care how deep it is.
namespace proskill::analysis {

/// Calls `visit` on each statement of a block, outer before inner, in the order of the text.
template <class Visit> void forEachStatement(const syntax::Block& block, Visit&& visit) {
  for (const syntax::Statement& statement : block.statements) {
    visit(statement);
    for (const syntax::Arm& arm : statement.arms) forEachStatement(arm.body, visit);
    for (const syntax::Block& branch : statement.branches) forEachStatement(branch, visit);
  }
}

/// The body of a composite skill, or of an environment.
struct Body {
  const syntax::Block& block;
  FileId file;
  SymbolId owner;
};

} // namespace proskill::analysis
