#pragma once

#include "analysis/flow/domain/condition.h"
#include "syntax/tree/ast.h"

namespace proskill::analysis::flow {

/// An assignment of a node with resolved names. Besides effects of the text there are implicit
/// ones: to statuses, results, and to which skills are called and how much of a resource is used.
struct Assignment {
  VariableId variable = 0;
  std::optional<Slot> slot; ///< nullopt: the process does not track the variable
  Term value;
  const syntax::Effect* source = nullptr; ///< in the text
};

/// The constant that an assignment adds to its own variable; nullopt: it does something else.
[[nodiscard]] std::optional<std::int64_t> stepOf(const Assignment& assignment);

/// The effect of an assignment on a variable whose value is in the class `from`.
struct Move {
  unsigned from = 0;
  ValueSet to;
  bool mayFallShort = false;  ///< below the minimum, where it saturates
  bool mayOvershoot = false;  ///< above the maximum, where it saturates
  bool alwaysOutside = false; ///< every possible value is out of bounds
};

/// One move for each class of possible values before the assignment. Right-hand sides are evaluated
/// in `before`.
[[nodiscard]] std::vector<Move> moves(const Assignment& assignment, const Domain& domain,
                                      const State& before);

} // namespace proskill::analysis::flow
