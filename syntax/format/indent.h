#pragma once

#include "syntax/document.h"

#include <string_view>

namespace proskill::syntax {

/// The indentation of a line, in spaces. Works also for incomplete programs, which the formatter
/// does not change. \param above the text above the line, from the beginning of its region
[[nodiscard]] std::uint32_t indentation(std::string_view above, std::string_view line);

/// The region that contains a position. At its beginning no form is open.
[[nodiscard]] Range regionAt(const Document& document, Offset at);

} // namespace proskill::syntax
