#pragma once

#include "syntax/text/source.h"

#include <span>
#include <string>
#include <string_view>

namespace proskill::syntax {

/// Replaces `range` by `text`.
struct TextEdit {
  Range range;
  std::string text;

  friend bool operator==(const TextEdit&, const TextEdit&) = default;
};

/// Applies all edits at once; their ranges refer to the original text.
/// \pre they are in the order of the text and do not overlap
[[nodiscard]] std::string applyEdits(std::string_view text, std::span<const TextEdit> edits);

} // namespace proskill::syntax
