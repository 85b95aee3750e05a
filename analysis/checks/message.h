#pragma once

#include "analysis/names/names.h"
#include "analysis/names/walk.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace proskill::analysis {

/// A `%` of a format with the letter after it; `\0` at the end of the format.
struct Directive {
  char letter = 0;
  std::size_t at = 0; ///< bytes from the start of the format
};
[[nodiscard]] std::vector<Directive> directives(std::string_view format);

/// Checks the format of a `printf` against its arguments. \pre `statement` is a Printf
void checkMessage(Context& context, const Body& body, const syntax::Statement& statement);

} // namespace proskill::analysis
