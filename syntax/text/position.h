#pragma once

#include "syntax/text/source.h"

#include <cstdint>
#include <string_view>

/// Conversion between bytes and editor columns.
namespace proskill::syntax {

/// The unit of columns. LSP 3.17, `PositionEncodingKind`.
enum class Encoding : std::uint8_t { Utf8, Utf16, Utf32 };

/// Counted from 0; `character` in units of the encoding.
struct EditorPosition {
  std::uint32_t line = 0;
  std::uint32_t character = 0;
  friend auto operator<=>(const EditorPosition&, const EditorPosition&) = default;
};

/// Bytes that are not UTF-8 count as one character each, as editors show them.
[[nodiscard]] EditorPosition toEditor(std::string_view text, const LineIndex& lines, Offset at,
                                      Encoding encoding);
/// The same, faster if the offset is in a line near `line`. Sets `line` to the offset's line.
[[nodiscard]] EditorPosition toEditor(std::string_view text, const LineIndex& lines, Offset at,
                                      Encoding encoding, std::uint32_t& line);
/// A column after the end of its line is the line's end; a line after the end of the text is the
/// text's end; a position within a character is the character's start.
[[nodiscard]] Offset fromEditor(std::string_view text, const LineIndex& lines,
                                EditorPosition position, Encoding encoding);

/// Converts offsets in ascending order; each call scans the text only from the previous offset.
class LineWalk {
public:
  LineWalk(std::string_view text, const LineIndex& lines, Encoding encoding)
      : text(text), lines(lines), encoding(encoding) {}

  /// \pre `at` is not less than in the previous call
  [[nodiscard]] EditorPosition to(Offset at);

private:
  std::string_view text;
  const LineIndex& lines;
  Encoding encoding;
  Offset here = 0;
  Offset nextLine = 0; ///< its begin; 0 before the first call
  EditorPosition position;
};

} // namespace proskill::syntax
