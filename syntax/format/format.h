#pragma once

#include "syntax/document.h"
#include "syntax/text/edit.h"

#include <vector>

/// The layout of programs: one style, described in docs/format.md. Formatting changes white space
/// between tokens and nothing else, so it cannot lose anything; and it is idempotent.
namespace proskill::syntax {

/// How wide a line may become before it is broken, in characters. A word or comment that is longer
/// is left alone.
inline constexpr std::uint32_t kLineWidth = 100;

/// The edits that lay a text out, as small as they can be, in the order of the text; none where it
/// is laid out already. Definitions that could not be read as they stand (a parenthesis is missing,
/// there is a character that means nothing) are left untouched.
[[nodiscard]] std::vector<TextEdit> format(const Document& document);

/// The definitions that are left untouched.
[[nodiscard]] std::vector<Range> unformattable(const Document& document);

/// Of the edits of the whole those in the lines that `lines` touches.
[[nodiscard]] std::vector<TextEdit> formatRange(const Document& document, Range lines);

/// After `typed` was typed just before `caret`: behind the end of a line, the indentation of the
/// new line; behind `)`, the layout of the form that it closes. Nothing for other characters, and
/// in comments and strings. No edit touches what is behind the caret's line.
[[nodiscard]] std::vector<TextEdit> formatTyped(const Document& document, Offset caret, char typed);

/// Whether two texts have the same tokens and comments in the same order, whatever the white space
/// between them and behind comments.
[[nodiscard]] bool sameTokens(const Document& a, const Document& b);

} // namespace proskill::syntax
