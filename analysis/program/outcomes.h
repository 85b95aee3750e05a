#pragma once

#include "syntax/tree/ast.h"

#include <string>
#include <string_view>
#include <vector>

namespace proskill::analysis {

/// An outcome of a call, as a `case` names it.
struct CallOutcome {
  std::string_view status; ///< `success`, `failure`, `failed_inv`, `interrupted`, `refused`
  std::string_view tag;    ///< empty: none
  friend bool operator==(const CallOutcome&, const CallOutcome&) = default;
};

/// All possible outcomes of a call of the skill, according to its declaration and the form of its
/// body, in the order of the declaration.
[[nodiscard]] std::vector<CallOutcome> outcomesOf(const syntax::Skill& skill);

/// Whether the pattern covers this outcome.
[[nodiscard]] bool matches(const syntax::CasePattern& pattern, const CallOutcome& outcome);

/// As written in an arm: `(success landed)`, `refused`.
[[nodiscard]] std::string toString(const CallOutcome& outcome);

} // namespace proskill::analysis
