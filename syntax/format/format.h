#pragma once

#include "syntax/document.h"
#include "syntax/text/edit.h"

#include <span>
#include <vector>

/// Formatting of programs: one style, described in docs/format.md. The formatter changes only white
/// space between tokens, so it cannot lose anything, and it is idempotent.
namespace proskill::syntax {

/// Maximal length of a line, in characters. A longer word or comment stays on one line.
inline constexpr std::uint32_t kLineWidth = 100;

/// Minimal edits that format a text, in the order of the text; none if it is formatted already.
/// Definitions with syntax errors (a missing parenthesis, a stray character) stay as they are.
[[nodiscard]] std::vector<TextEdit> format(const Document& document);

/// The definitions that the formatter does not change.
[[nodiscard]] std::vector<Range> unformattable(const Document& document);

/// The edits of the whole text that are in the lines that `lines` touches.
[[nodiscard]] std::vector<TextEdit> formatRange(const Document& document, Range lines);

/// Formatting while typing: the edits after `typed` was typed just before `caret`. After a line
/// end, the new line and the one above it are indented; after the `)` that ends a definition, the
/// definition is formatted. Not after others: editors insert the `)` of a form with its `(`, and
/// take one that is typed for it only as long as nothing else changes the line. No edits for other
/// characters, nor in comments and strings. No edit touches anything after the caret's line.
[[nodiscard]] std::vector<TextEdit> formatTyped(const Document& document, Offset caret, char typed);

/// Formatting of lines that were typed earlier: their indentation, each below the lines above it as
/// they are then, and no white space at their ends. Works also in incomplete programs.
/// \param lines their numbers, ascending
[[nodiscard]] std::vector<TextEdit> formatLines(const Document& document,
                                                std::span<const std::uint32_t> lines);

/// Whether two texts have the same tokens and comments in the same order, regardless of white space
/// between them and at the end of comments.
[[nodiscard]] bool sameTokens(const Document& a, const Document& b);

} // namespace proskill::syntax
