#pragma once

#include "syntax/text/source.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

/// Differences between two versions of a text.
namespace proskill::syntax {

/// Replacement of a part of a text. The text before it stays in place; the text after it moves.
struct Replacement {
  Offset begin = 0;
  Offset oldEnd = 0;
  Offset newEnd = 0;

  [[nodiscard]] Range before() const { return {begin, oldEnd}; }
  [[nodiscard]] Range after() const { return {begin, newEnd}; }
  /// Whether an empty text is replaced by an empty text.
  [[nodiscard]] bool isEmpty() const { return begin == oldEnd && begin == newEnd; }
  /// The new position of a range of the old text; nothing if it begins or ends in the replaced
  /// part.
  [[nodiscard]] std::optional<Range> moved(Range range) const;
  /// The same for any range: its replaced parts are removed, and text inserted into it is included.
  [[nodiscard]] Range nearest(Range range) const;
  /// The replacement that turns the new text back into the old one.
  [[nodiscard]] Replacement inverse() const { return {begin, newEnd, oldEnd}; }

  friend bool operator==(const Replacement&, const Replacement&) = default;
};

inline std::optional<Range> Replacement::moved(Range range) const {
  const Offset by = newEnd - oldEnd; // may wrap around; adding it wraps back
  if (range.end < begin || (range.end == begin && !range.empty())) return range;
  if (range.begin > oldEnd || (range.begin == oldEnd && !range.empty())) return range.moved(by);
  if (range.begin < begin && range.end > oldEnd) return Range{range.begin, range.end + by};
  return std::nullopt;
}

/// The difference between two documents.
struct Change {
  Replacement regions; ///< the regions that were parsed again; nothing else changed
  /// Set if only comments and white space changed: the changed part. All words still exist, at the
  /// places that `moved` gives.
  std::optional<Replacement> layout;
};

/// The numbers of equal items at the beginning and at the end of two lists. Each item counts once.
struct CommonEnds {
  std::size_t front = 0;
  std::size_t back = 0;
};
template <class A, class B, class Same = std::equal_to<>>
CommonEnds commonEnds(const A& a, const B& b, Same same = {}) {
  const std::size_t most = std::min(a.size(), b.size());
  std::size_t front = 0;
  while (front < most && same(a[front], b[front])) ++front;
  std::size_t back = 0;
  while (back < most - front && same(a[a.size() - 1 - back], b[b.size() - 1 - back])) ++back;
  return {front, back};
}

/// The shortest replacement that turns `before` into `now`.
[[nodiscard]] Replacement replacementOf(std::string_view before, std::string_view now);

/// Whether both texts have the same words, at the places to which the replacement moves them.
/// \pre the replacement turns one into the other; what follows the texts begins a line
[[nodiscard]] bool isLayout(std::string_view before, std::string_view now, const Replacement& edit);

} // namespace proskill::syntax
