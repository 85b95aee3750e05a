#pragma once

#include "codegen/plan/body_automaton.h"

#include <set>

namespace proskill::codegen {

/// The states of a body, or of a branch, to which some path from its entry leads. A `//` with a
/// branch that never reaches its end does not continue, nor does a `race` whose branches all end
/// the skill.
[[nodiscard]] std::set<std::string_view> statesOnPaths(const BodyAutomaton& body);

/// Whether some path leads to the end of the body, so that it ends without `(success …)` or
/// `(failure …)`.
[[nodiscard]] bool mayReachEnd(const BodyAutomaton& body);

} // namespace proskill::codegen
