#pragma once

#include "syntax/diagnostics/diagnostic.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace proskill::syntax {

/// How many letters must be inserted, deleted, replaced or swapped with their neighbour to turn one
/// word into the other (optimal string alignment), where it is at most `limit`. Case counts for
/// nothing, so that `good` is at distance 0 from `Good`.
[[nodiscard]] std::optional<std::size_t> editDistance(std::string_view a, std::string_view b,
                                                      std::size_t limit);

/// Keeps the best of the words that it is offered: the one with the fewest mistakes; of equals one
/// that only has letters too few or too many, as `Off` for `Of`, before one with others, as `On`;
/// then the first.
class Suggestion {
public:
  explicit Suggestion(std::string_view misspelt);

  /// Whether the word is the best one so far.
  bool offer(std::string_view word);
  /// The word that was probably meant; empty where none is near enough.
  [[nodiscard]] std::string_view best() const { return found; }

private:
  std::string_view misspelt;
  std::string_view found;
  std::size_t limit;       ///< a word must be this near to be looked at
  std::size_t nearest = 0; ///< how far `found` is
  bool replaced = true;    ///< `found` has other letters, not just more or fewer
  bool full = false;       ///< nothing can be nearer
};

/// The word of these that was probably meant; empty where none is near enough.
[[nodiscard]] std::string_view nearest(std::string_view misspelt, const auto& words) {
  Suggestion suggestion(misspelt);
  for (std::string_view word : words) suggestion.offer(word);
  return suggestion.best();
}

/// Gives the diagnostic of the misspelt word the edit that writes what was probably meant; none
/// where that is empty.
void suggest(Diagnostic& diagnostic, std::string_view word);

} // namespace proskill::syntax
