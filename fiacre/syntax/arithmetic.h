#pragma once

#include "fiacre/syntax/tree.h"

namespace proskill::fiacre {

/// Of two numbers, as Fiacre's C computes; nothing by zero, beyond 64 bits, or for what is no
/// arithmetic.
[[nodiscard]] std::optional<std::int64_t> compute(Op op, std::int64_t a, std::int64_t b);

} // namespace proskill::fiacre
