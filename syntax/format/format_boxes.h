#pragma once

#include "syntax/document.h"

#include <cstdint>
#include <optional>
#include <vector>

/// What the layout of a text is computed from: its tokens and comments, nested as in the concrete
/// tree.
namespace proskill::syntax {

enum class BoxShape : std::uint8_t {
  Word,    // one token
  Tight,   // tokens without space between them: an interval
  Comment, // to the end of its line
  Form,    // in parentheses
  Group,   // children that belong together: a tag and its clause, a keyword and its values
};

inline constexpr std::uint32_t kNotFlat = UINT32_MAX;

/// A box with its descendants behind it, as in `Tree`.
struct Box {
  BoxShape shape = BoxShape::Word;
  NodeKind kind = NodeKind::Token;
  std::uint32_t size = 1;
  Range range;            ///< in the document
  std::uint32_t flat = 0; ///< characters on one line; kNotFlat where it does not stand on one
  std::uint32_t children = 0;
};

using Boxes = std::vector<Box>;

[[nodiscard]] bool isField(NodeKind kind);
/// Whether a line ends between two places.
[[nodiscard]] bool lineEndsIn(std::string_view text, Offset from, Offset to);
/// Whether, in a `:success` or `:failure`, the author broke the line behind a tag: its clause then
/// hangs below the keyword.
[[nodiscard]] bool clauseStartsLine(std::string_view text, const Boxes& boxes, std::size_t field);

/// The boxes of a region of a document, those at its top level one after the other. Nothing where
/// it holds what the grammar does not take as it stands.
[[nodiscard]] std::optional<Boxes> boxesOf(std::string_view text, const Region& region);

} // namespace proskill::syntax
