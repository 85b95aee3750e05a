#pragma once

#include "ide/actions/action.h"

#include <functional>
#include <span>

/// What actions on bodies share.
namespace proskill::ide {

/// Statements of one block that follow each other, and the definition that they stand in.
struct Selected {
  const syntax::Form* form = nullptr;
  const syntax::Skill* skill = nullptr;
  std::span<const syntax::Statement> statements; ///< not empty

  [[nodiscard]] syntax::Range range() const {
    return {statements.front().range.begin, statements.back().range.end};
  }
};

/// The statements of a skill's body that are selected; of a selection within one statement, the
/// innermost. Empty where there are none.
[[nodiscard]] Selected selectedStatements(const ActionContext& context);

/// Whether any statement, however deep, is of one of these kinds.
[[nodiscard]] bool contains(std::span<const syntax::Statement> statements,
                            std::initializer_list<syntax::StatementKind> kinds);

/// Whether a `break` would leave a loop around the statements.
[[nodiscard]] bool breaksOut(std::span<const syntax::Statement> statements);

/// The blocks of a statement.
void forEachBlock(const syntax::Statement& statement,
                  const std::function<void(const syntax::Block&)>& visit);

} // namespace proskill::ide
