#pragma once

#include "syntax/text/source.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// Lexical analysis without the grammar: comments, strings, parentheses, lines.
namespace proskill::syntax {

/// Maximal length of a text that is parsed, in bytes. A longer text is one region without forms,
/// because the forms of such a program would take gigabytes.
inline constexpr std::size_t kLongestRead = std::size_t{16} << 20;

/// The regions that are parsed separately: one from each line that begins with a definition, and
/// one before the first. They cover the text. So an edit or an error affects only its own region.
[[nodiscard]] std::vector<Range> cut(std::string_view text);

/// The text of a comment line without its semicolons; nothing if the line is not a comment.
[[nodiscard]] std::optional<std::string_view> commentLine(std::string_view line);

struct Parenthesis {
  Offset at;
  Offset column; ///< in bytes
  bool opens;
};

/// A token whose intended nesting depth is visible: the first of a line, or a keyword.
struct Landmark {
  Offset at;
  Offset column;
  Offset previousEnd;        ///< the end of the token before it
  std::uint32_t parentheses; ///< number of parentheses before it
  bool startsLine;
  bool keyword;
  bool fieldOfDefinition; ///< a keyword that occurs only directly in a definition
};

struct Scan {
  std::vector<Range> comments;
  /// Strings without a closing quote, up to the end of their lines.
  std::vector<Range> unterminated;
  std::vector<Parenthesis> parentheses;
  std::vector<Landmark> landmarks;
  Offset end = 0; ///< of the last token
};

/// The words that begin a definition.
inline constexpr std::array<std::string_view, 9> kDefinitionWords = {
    "defconst",    "defsv",          "defevent",    "defskill", "defresource",
    "defproperty", "defenvironment", "defplatform", "include",
};

[[nodiscard]] Scan scan(std::string_view text);

} // namespace proskill::syntax
