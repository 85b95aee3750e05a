#pragma once

#include "analysis/flow/engine/system.h"

#include <cstdint>
#include <optional>

namespace proskill::analysis::flow {

/// The greatest value of a natural that is set to a number before a fork, and that only the
/// branches of this fork count up. The solver lets each branch count any number of times; here, a
/// branch counts as often as its longest path does. nullopt: the natural is changed otherwise, or a
/// branch counts in a loop.
[[nodiscard]] std::optional<std::int64_t> mostCounted(const System& system, VariableId variable);

} // namespace proskill::analysis::flow
