#pragma once

#include "fiacre/format/format_spacing.h"

#include <string>
#include <string_view>
#include <vector>

/// Internals of the formatter: a text is split into lines by its structure, and lines are printed.
namespace proskill::fiacre {

/// Tokens that are on one line unless it is too long: a statement, a head, a declaration.
struct FormatLine {
  enum class Shape : std::uint8_t {
    Statement,
    Items, ///< `var`, `port`: one per line if there are comments
    Type,  ///< a record or a union: several lines if it is long or has comments
    Head,  ///< one line for each port and parameter if it is too long
    Comment,
  };
  Shape shape = Shape::Statement;
  LineKind kind = LineKind::Plain;
  std::size_t indent = 0;
  std::size_t hang = 4;      ///< additional indentation of continuation lines
  std::string lead;          ///< before the tokens: `[]`, `||`, `|`
  std::size_t leadWidth = 0; ///< its width in columns
  bool blank = false;        ///< there is an empty line before it
  std::vector<Token> tokens;
};

/// The lines of a model without syntax errors.
/// \param tokens of `text`, including comments
[[nodiscard]] std::vector<FormatLine> splitLines(std::string_view text,
                                                 const std::vector<Token>& tokens);

/// Whether there is a line end between two tokens.
[[nodiscard]] bool isLineBreak(std::string_view text, const Token& before, const Token& after);

/// The tokens on one line, of any length.
[[nodiscard]] std::string onOneLine(LineKind kind, const std::vector<Token>& tokens);

/// The text of all lines.
[[nodiscard]] std::string writeLines(std::string_view text, const std::vector<FormatLine>& lines);

} // namespace proskill::fiacre
