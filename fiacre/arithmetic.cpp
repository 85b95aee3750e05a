#include "fiacre/arithmetic.h"

#include <limits>

namespace proskill::fiacre {

std::optional<std::int64_t> compute(Op op, std::int64_t a, std::int64_t b) {
  std::int64_t result = 0;
  switch (op) {
  case Op::Add: return __builtin_add_overflow(a, b, &result) ? std::nullopt : std::optional(result);
  case Op::Subtract:
    return __builtin_sub_overflow(a, b, &result) ? std::nullopt : std::optional(result);
  case Op::Multiply:
    return __builtin_mul_overflow(a, b, &result) ? std::nullopt : std::optional(result);
  case Op::Divide:
  case Op::Modulo:
    if (b == 0 || (a == std::numeric_limits<std::int64_t>::min() && b == -1)) return std::nullopt;
    return op == Op::Divide ? a / b : a % b;
  default: return std::nullopt;
  }
}

} // namespace proskill::fiacre
