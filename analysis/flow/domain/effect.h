#pragma once

#include "analysis/flow/domain/condition.h"
#include "syntax/tree/ast.h"

namespace proskill::analysis::flow {

/// An assignment of a node, its names resolved. Besides those of the text there are those of the
/// language: to statuses, results, and to what is running and used.
struct Assignment {
  VariableId variable = 0;
  std::optional<Slot> slot; ///< nothing where the process does not follow the variable
  Term value;
  const syntax::Effect* source = nullptr; ///< in the text
};

/// What an assignment does to a variable that has a value of the class `from`.
struct Move {
  unsigned from = 0;
  ValueSet to;
  bool mayFallShort = false;  ///< below the minimum; it saturates
  bool mayOvershoot = false;  ///< above the maximum; it saturates
  bool alwaysOutside = false; ///< one of both for sure
};

/// One move for each class that the variable may have before. Right-hand sides are read in
/// `before`.
[[nodiscard]] std::vector<Move> moves(const Assignment& assignment, const Domain& domain,
                                      const State& before);

} // namespace proskill::analysis::flow
