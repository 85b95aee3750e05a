#pragma once

#include "syntax/text/source.h"

#include <cstdint>
#include <string_view>

/// The one place where bytes become the columns of an editor and back.
namespace proskill::syntax {

/// In what a column is counted. LSP 3.17, `PositionEncodingKind`.
enum class Encoding : std::uint8_t { Utf8, Utf16, Utf32 };

/// Counted from 0; `character` in units of the encoding.
struct EditorPosition {
  std::uint32_t line = 0;
  std::uint32_t character = 0;
  friend auto operator<=>(const EditorPosition&, const EditorPosition&) = default;
};

/// Bytes that are no UTF-8 count as one character each, as editors show them.
[[nodiscard]] EditorPosition toEditor(std::string_view text, const LineIndex& lines, Offset at,
                                      Encoding encoding);
/// The same, sooner where the place is in a line near to `line`, which it sets to its own.
[[nodiscard]] EditorPosition toEditor(std::string_view text, const LineIndex& lines, Offset at,
                                      Encoding encoding, std::uint32_t& line);
/// A column beyond its line is the line's end; a line beyond the text is the text's end; a place
/// within a character is the character's start.
[[nodiscard]] Offset fromEditor(std::string_view text, const LineIndex& lines,
                                EditorPosition position, Encoding encoding);

/// `toEditor` of places in the order of a text, each at the cost of the way from the last one.
class LineWalk {
public:
  LineWalk(std::string_view text, const LineIndex& lines, Encoding encoding)
      : text(text), lines(lines), encoding(encoding) {}

  /// \pre `at` is not before the place of the last call
  [[nodiscard]] EditorPosition to(Offset at);

private:
  std::string_view text;
  const LineIndex& lines;
  Encoding encoding;
  Offset here = 0;
  Offset nextLine = 0; ///< where it begins; 0 before the first call
  EditorPosition position;
};

} // namespace proskill::syntax
