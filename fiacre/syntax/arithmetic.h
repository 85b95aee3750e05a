#pragma once

#include "fiacre/syntax/tree.h"

namespace proskill::fiacre {

/// Arithmetic on two numbers, as Fiacre's C code computes it; nothing for division by zero, results
/// beyond 64 bits, and other operators.
[[nodiscard]] std::optional<std::int64_t> compute(Op op, std::int64_t a, std::int64_t b);

} // namespace proskill::fiacre
