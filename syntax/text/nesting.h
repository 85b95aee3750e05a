#pragma once

#include "syntax/text/scan.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace proskill::syntax {

/// The changes that were made so far to make a text balance.
struct Recovery {
  std::vector<bool> removed;          ///< by parenthesis
  std::vector<std::uint8_t> inserted; ///< `)` before each landmark, and at the end of the text
};

/// How well the nesting of a text, with some changes to it, agrees with its indentation and with
/// the keywords of definitions, which stand directly in them.
struct Nesting {
  unsigned penalty = 0;
  std::vector<unsigned>
      doubts; ///< by landmark: how much it seems to stand too deep, or not deep enough
  std::optional<std::size_t> surplus;         ///< the first `)` that closes nothing
  std::vector<std::size_t> open;              ///< the `(` that are never closed, outermost first
  std::vector<std::size_t> closedByInsertion; ///< the `(` that the inserted `)` close, in order
};

/// Where a `)` before that landmark, or at the end, is inserted: directly behind the token before
/// it.
[[nodiscard]] inline Offset placeBefore(const Scan& scan, std::size_t landmark) {
  return landmark < scan.landmarks.size() ? scan.landmarks[landmark].previousEnd : scan.end;
}

[[nodiscard]] Nesting nestingOf(std::string_view text, const Scan& scan, const Recovery& recovery);

} // namespace proskill::syntax
