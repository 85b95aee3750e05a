#pragma once

#include "syntax/diagnostics/diagnostic.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace proskill::syntax {

/// The edit distance of two words (optimal string alignment): how many letters must be inserted,
/// deleted, replaced or swapped with their neighbour to turn one into the other. Nothing if it
/// exceeds `limit`. Case is ignored, so `good` has distance 0 from `Good`.
[[nodiscard]] std::optional<std::size_t> editDistance(std::string_view a, std::string_view b,
                                                      std::size_t limit);

/// Keeps the best of the words that it is offered. The best word has the smallest distance. Among
/// equals, words that only add or omit letters, as `Off` for `Of`, go before words that replace
/// letters, as `On`; then the first word wins.
class Suggestion {
public:
  explicit Suggestion(std::string_view misspelt);

  /// Offers a word. Returns whether it is the best one so far.
  bool offer(std::string_view word);
  /// The word that was probably meant; empty if none is close enough.
  [[nodiscard]] std::string_view best() const { return found; }

private:
  std::string_view misspelt;
  std::string_view found;
  std::size_t limit;       ///< the maximal distance of a word
  std::size_t nearest = 0; ///< the distance of `found`
  bool replaced = true;    ///< `found` replaces letters instead of only adding or omitting some
  bool full = false;       ///< no other word can be closer
};

/// The word that was probably meant; empty if none is close enough.
[[nodiscard]] std::string_view nearest(std::string_view misspelt, const auto& words) {
  Suggestion suggestion(misspelt);
  for (std::string_view word : words) suggestion.offer(word);
  return suggestion.best();
}

/// Adds a fix that replaces the misspelt word by `word`; none if `word` is empty.
void suggest(Diagnostic& diagnostic, std::string_view word);

} // namespace proskill::syntax
