#pragma once

#include "syntax/text/source.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

/// How one text became another.
namespace proskill::syntax {

/// A region of a text that was put in the place of another: what stands before it stays, what
/// stands behind it moves.
struct Replacement {
  Offset begin = 0;
  Offset oldEnd = 0;
  Offset newEnd = 0;

  [[nodiscard]] Range before() const { return {begin, oldEnd}; }
  [[nodiscard]] Range after() const { return {begin, newEnd}; }
  /// Nothing stands in the place of nothing.
  [[nodiscard]] bool isEmpty() const { return begin == oldEnd && begin == newEnd; }
  /// Where a range of the old text stands now; nothing where it begins or ends in what is gone.
  [[nodiscard]] std::optional<Range> moved(Range range) const;
  /// The same of any range: what of it is gone is left out, what was put into it is in it.
  [[nodiscard]] Range nearest(Range range) const;
  /// What makes the old text of the new one.
  [[nodiscard]] Replacement inverse() const { return {begin, newEnd, oldEnd}; }

  friend bool operator==(const Replacement&, const Replacement&) = default;
};

inline std::optional<Range> Replacement::moved(Range range) const {
  const Offset by = newEnd - oldEnd; // may wrap around, and back when it is added
  if (range.end < begin || (range.end == begin && !range.empty())) return range;
  if (range.begin > oldEnd || (range.begin == oldEnd && !range.empty())) return range.moved(by);
  if (range.begin < begin && range.end > oldEnd) return Range{range.begin, range.end + by};
  return std::nullopt;
}

/// What changed between two documents.
struct Change {
  Replacement regions; ///< that were read anew; nothing outside of them is other than before
  /// Where only comments and white space differ, what of them: every word is still there, and the
  /// place of each is that which `moved` gives.
  std::optional<Replacement> layout;
};

/// How many items two lists begin with, and end with, that are the same; each counts once.
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

/// The shortest replacement that makes one text of the other.
[[nodiscard]] Replacement replacementOf(std::string_view before, std::string_view now);

/// Whether the texts have the same words, each where the replacement moves it.
/// \pre the replacement makes one of the other; what follows them begins a line
[[nodiscard]] bool isLayout(std::string_view before, std::string_view now, const Replacement& edit);

} // namespace proskill::syntax
