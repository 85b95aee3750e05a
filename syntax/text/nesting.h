#pragma once

#include "syntax/text/scan.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace proskill::syntax {

/// The changes made so far to balance the parentheses of a text.
struct Recovery {
  std::vector<bool> removed; ///< by parenthesis
  /// Number of `)` inserted before each landmark and at the end of the text.
  std::vector<std::uint8_t> inserted;
};

/// How well the nesting of a text, with some changes, agrees with its indentation and with keywords
/// that occur only directly in definitions.
struct Nesting {
  unsigned penalty = 0;
  std::vector<unsigned>
      doubts; ///< by landmark: by how much it seems to be nested too deep or not deep enough
  std::optional<std::size_t> surplus;         ///< the first `)` that closes nothing
  std::vector<std::size_t> open;              ///< the `(` without a `)`, outermost first
  std::vector<std::size_t> closedByInsertion; ///< the `(` that inserted `)` close, in order
};

/// Where a `)` before this landmark or at the end is inserted: directly after the previous token.
[[nodiscard]] inline Offset placeBefore(const Scan& scan, std::size_t landmark) {
  return landmark < scan.landmarks.size() ? scan.landmarks[landmark].previousEnd : scan.end;
}

[[nodiscard]] Nesting nestingOf(std::string_view text, const Scan& scan, const Recovery& recovery);

} // namespace proskill::syntax
