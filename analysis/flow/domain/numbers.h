#pragma once

#include "analysis/program/program.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace proskill::analysis::flow {

/// The value of an integer literal; nothing for other expressions.
[[nodiscard]] std::optional<std::int64_t> wholeNumber(const syntax::Expr& expr);

/// 1 for `true`, 0 for `false`; nothing for other expressions.
[[nodiscard]] std::optional<std::int64_t> truthValue(const syntax::Expr& expr);

/// All integer literals in conditions and effects of the program, with duplicates. Large domains
/// are split at these.
[[nodiscard]] std::vector<std::int64_t> numbersIn(const Program& program);

} // namespace proskill::analysis::flow
