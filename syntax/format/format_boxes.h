#pragma once

#include "syntax/document.h"

#include <cstdint>
#include <optional>
#include <vector>

/// The input of formatting: a text's tokens and comments, nested as in the concrete tree.
namespace proskill::syntax {

enum class BoxShape : std::uint8_t {
  Word,    // one token
  Tight,   // tokens without white space between them: an interval
  Comment, // up to the end of its line
  Form,    // a list in parentheses
  Group,   // children that belong together: a tag and its clause, a keyword and its values
};

inline constexpr std::uint32_t kNotFlat = UINT32_MAX;

/// A box, followed by its descendants as in `Tree`.
struct Box {
  BoxShape shape = BoxShape::Word;
  NodeKind kind = NodeKind::Token;
  std::uint32_t size = 1;
  Range range; ///< in the document
  /// Its length on one line, in characters; kNotFlat if it cannot be on one line.
  std::uint32_t flat = 0;
  std::uint32_t children = 0;
};

using Boxes = std::vector<Box>;

[[nodiscard]] bool isField(NodeKind kind);
/// Whether there is a line end between two offsets.
[[nodiscard]] bool lineEndsIn(std::string_view text, Offset from, Offset to);
/// Whether the author broke the line after a tag in `:success` or `:failure`. If so, its clause is
/// indented below the keyword.
[[nodiscard]] bool clauseStartsLine(std::string_view text, const Boxes& boxes, std::size_t field);

/// The boxes of a region, those of the top level in sequence. Nothing if the region has a syntax
/// error.
[[nodiscard]] std::optional<Boxes> boxesOf(std::string_view text, const Region& region);

} // namespace proskill::syntax
