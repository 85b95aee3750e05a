#pragma once

#include "fiacre/format/format_spacing.h"

#include <string>
#include <string_view>
#include <vector>

/// The formatter's own pieces: a text becomes lines by its structure, and the lines text.
namespace proskill::fiacre {

/// What belongs on one line, if it is not too long: a statement, a head, a declaration.
struct FormatLine {
  enum class Shape : std::uint8_t {
    Statement,
    Items, ///< `var`, `port`: one a line where there are comments
    Type,  ///< a record or a union takes several lines where it is long or has comments
    Head,  ///< ports and parameters have a line each where it is too long
    Comment,
  };
  Shape shape = Shape::Statement;
  LineKind kind = LineKind::Plain;
  std::size_t indent = 0;
  std::size_t hang = 4;      ///< how much further in it goes on
  std::string lead;          ///< before the tokens: `[]`, `||`, `|`
  std::size_t leadWidth = 0; ///< columns that it takes
  bool blank = false;        ///< an empty line before it
  std::vector<Token> tokens;
};

/// The lines of a model that has no problem of syntax. `tokens` are of `text`, with comments.
[[nodiscard]] std::vector<FormatLine> splitLines(std::string_view text,
                                                 const std::vector<Token>& tokens);

/// Whether white space between two tokens has a line's end.
[[nodiscard]] bool isLineBreak(std::string_view text, const Token& before, const Token& after);

/// The tokens on one line, however long.
[[nodiscard]] std::string onOneLine(LineKind kind, const std::vector<Token>& tokens);

/// The text of all lines.
[[nodiscard]] std::string writeLines(std::string_view text, const std::vector<FormatLine>& lines);

} // namespace proskill::fiacre
