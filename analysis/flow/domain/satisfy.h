#pragma once

#include "analysis/flow/domain/condition.h"

#include <functional>
#include <set>
#include <span>

namespace proskill::analysis::flow {

/// Adds the variables that a condition reads.
void collectSlots(const Condition& condition, std::set<Slot>& slots);

/// Whether some state within `within` makes all conditions true and satisfies `wanted`. In the
/// states that `wanted` gets, each of `slots` and each variable of the conditions has a single
/// value, so conditions over words are exact there. Answers true if there are too many states.
[[nodiscard]] bool isPossible(const State& within, std::span<const Condition> conditions,
                              std::set<Slot> slots,
                              const std::function<bool(const State&)>& wanted);

/// Whether all conditions can be true together.
[[nodiscard]] bool mayHoldTogether(const State& within, std::span<const Condition> conditions);
/// Whether the condition can be false where all of `held` are true.
[[nodiscard]] bool mayFailBeside(const State& within, std::span<const Condition> held,
                                 const Condition& condition);

} // namespace proskill::analysis::flow
