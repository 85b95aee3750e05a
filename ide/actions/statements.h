#pragma once

#include "ide/actions/action.h"

#include <functional>
#include <span>

/// Shared parts of actions on bodies.
namespace proskill::ide {

/// Consecutive statements of one block, and the definition that contains them.
struct Selected {
  const syntax::Form* form = nullptr;
  const syntax::Skill* skill = nullptr;
  std::span<const syntax::Statement> statements; ///< not empty

  [[nodiscard]] syntax::Range range() const {
    return {statements.front().range.begin, statements.back().range.end};
  }
};

/// The selected statements of a skill's body; for a selection within one statement, the innermost.
/// Empty if there are none.
[[nodiscard]] Selected selectedStatements(const ActionContext& context);

/// Whether any statement, at any depth, is of one of these kinds.
[[nodiscard]] bool contains(std::span<const syntax::Statement> statements,
                            std::initializer_list<syntax::StatementKind> kinds);

/// Whether the statements contain a `break` of a loop around them.
[[nodiscard]] bool breaksOut(std::span<const syntax::Statement> statements);

/// The blocks of a statement.
void forEachBlock(const syntax::Statement& statement,
                  const std::function<void(const syntax::Block&)>& visit);

} // namespace proskill::ide
