#pragma once

#include "syntax/tree/ast.h"

#include <string>
#include <string_view>
#include <vector>

namespace proskill::analysis {

/// One way in which a call can end, as a `case` names it.
struct CallOutcome {
  std::string_view status; ///< `success`, `failure`, `failed_inv`, `interrupted`, `refused`
  std::string_view tag;    ///< empty where it has none
  friend bool operator==(const CallOutcome&, const CallOutcome&) = default;
};

/// All ways in which a call of the skill can end, as far as its declaration and the form of its
/// body tell, in the order of the declaration.
[[nodiscard]] std::vector<CallOutcome> outcomesOf(const syntax::Skill& skill);

/// The pattern is for this outcome.
[[nodiscard]] bool matches(const syntax::CasePattern& pattern, const CallOutcome& outcome);

/// As an arm is written: `(success landed)`, `refused`.
[[nodiscard]] std::string toString(const CallOutcome& outcome);

} // namespace proskill::analysis
