#pragma once

#include "syntax/document.h"

namespace proskill::syntax {

/// How many spaces the line that contains `at` begins with, as far as the lines above it tell; also
/// for a program in the middle of being typed, which the formatter leaves alone.
[[nodiscard]] std::uint32_t indentationAt(const Document& document, Offset at);

} // namespace proskill::syntax
