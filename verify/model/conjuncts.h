#pragma once

#include "verify/model/system.h"

namespace proskill::verify {

/// The operands of a conjunction, nested conjunctions flattened.
[[nodiscard]] std::vector<NodeId> conjunctsOf(const System& system, NodeId node);

} // namespace proskill::verify
