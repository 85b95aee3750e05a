#pragma once

#include "syntax/text/source.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// What can be told of a text without its grammar: comments, strings, parentheses, lines.
namespace proskill::syntax {

/// A longer text, in bytes, is one region, which is not read: the forms of a program of this
/// length take gigabytes.
inline constexpr std::size_t kLongestRead = std::size_t{16} << 20;

/// The regions that are parsed each on its own: one from each line that begins with a definition,
/// and one before the first. They cover the text; so an edit, or a mistake, stays in its region.
[[nodiscard]] std::vector<Range> cut(std::string_view text);

/// What a line of comment says, without its semicolons; nothing where the line is none.
[[nodiscard]] std::optional<std::string_view> commentLine(std::string_view line);

struct Parenthesis {
  Offset at;
  Offset column; ///< in bytes
  bool opens;
};

/// A token that tells how deep it means to stand: the first of a line, or a keyword.
struct Landmark {
  Offset at;
  Offset column;
  Offset previousEnd;        ///< the end of the token before it
  std::uint32_t parentheses; ///< how many stand before it
  bool startsLine;
  bool keyword;
  bool fieldOfDefinition; ///< a keyword that only stands directly in a definition
};

struct Scan {
  std::vector<Range> comments;
  std::vector<Range> unterminated; ///< strings, to the end of their lines
  std::vector<Parenthesis> parentheses;
  std::vector<Landmark> landmarks;
  Offset end = 0; ///< of the last token
};

/// The words that begin a definition.
inline constexpr std::array<std::string_view, 7> kDefinitionWords = {
    "defsv", "defevent", "defskill", "defresource", "defproperty", "defenvironment", "include",
};

[[nodiscard]] Scan scan(std::string_view text);

} // namespace proskill::syntax
