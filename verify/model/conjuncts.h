#pragma once

#include "verify/model/system.h"

namespace proskill::verify {

/// The conditions that an expression is the conjunction of.
[[nodiscard]] std::vector<NodeId> conjunctsOf(const System& system, NodeId node);

} // namespace proskill::verify
