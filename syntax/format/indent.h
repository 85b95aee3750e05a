#pragma once

#include "syntax/document.h"

namespace proskill::syntax {

/// The indentation, in spaces, of the line that contains `at`, computed from the lines above it.
/// Works also for incomplete programs, which the formatter does not change.
[[nodiscard]] std::uint32_t indentationAt(const Document& document, Offset at);

} // namespace proskill::syntax
