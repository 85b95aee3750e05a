#include "fiacre/syntax/arithmetic.h"

#include <limits>
#include <utility>

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
  case Op::Not:
  case Op::Negate:
  case Op::Coerce:
  case Op::Empty:
  case Op::Full:
  case Op::First:
  case Op::Dequeue:
  case Op::And:
  case Op::Or:
  case Op::Equal:
  case Op::NotEqual:
  case Op::Less:
  case Op::LessEqual:
  case Op::Greater:
  case Op::GreaterEqual:
  case Op::Enqueue:
  case Op::Append: return std::nullopt;
  }
  std::unreachable();
}

} // namespace proskill::fiacre
