#pragma once

#include "analysis/program/program.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace proskill::analysis::flow {

/// The value of a whole number as written; nothing where the expression is none.
[[nodiscard]] std::optional<std::int64_t> wholeNumber(const syntax::Expr& expr);

/// Every whole number that stands in a condition or an effect of the program, with duplicates: the
/// places where large domains are worth a cut.
[[nodiscard]] std::vector<std::int64_t> numbersIn(const Program& program);

} // namespace proskill::analysis::flow
