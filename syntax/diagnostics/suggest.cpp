#include "syntax/diagnostics/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace proskill::syntax {

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// In bytes. Longer names are not compared: the table would be large.
constexpr std::size_t kLongestName = 64;

/// Number of typing errors allowed in a word: one in three letters. A name of one letter resembles
/// all others.
std::size_t mistakesIn(std::string_view word) {
  return word.size() < 2 ? 0 : std::max<std::size_t>(1, word.size() / 3);
}

/// Whether the shorter word is a subsequence of the longer one.
bool isWithin(std::string_view shorter, std::string_view longer) {
  for (char c : longer)
    if (!shorter.empty() && lower(shorter.front()) == lower(c)) shorter.remove_prefix(1);
  return shorter.empty();
}

} // namespace

std::optional<std::size_t> editDistance(std::string_view a, std::string_view b, std::size_t limit) {
  const std::size_t gap = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
  if (gap > limit) return std::nullopt;
  std::vector<std::size_t> table(3 * (b.size() + 1));
  std::size_t* beforeLast = table.data();
  std::size_t* last = beforeLast + b.size() + 1;
  std::size_t* row = last + b.size() + 1;
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(beforeLast, last);
    std::swap(last, row);
    row[0] = i;
    std::size_t nearest = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                           lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], beforeLast[j - 2] + 1);
      nearest = std::min(nearest, row[j]);
    }
    if (nearest > limit) return std::nullopt;
  }
  if (row[b.size()] > limit) return std::nullopt;
  return row[b.size()];
}

Suggestion::Suggestion(std::string_view word)
    : misspelt(word), limit(mistakesIn(word)), full(word.empty() || word.size() > kLongestName) {}

bool Suggestion::offer(std::string_view word) {
  if (full || word.empty() || word == misspelt) return false;
  const auto distance = editDistance(misspelt, word, limit);
  if (!distance) return false;
  const bool other = !isWithin(misspelt, word) && !isWithin(word, misspelt);
  const bool isNearer = found.empty() || *distance < nearest;
  if (!isNearer && (other || !replaced)) return false;
  found = word;
  replaced = other;
  nearest = limit = *distance;
  full = nearest == 0;
  return true;
}

void suggest(Diagnostic& diagnostic, std::string_view word) {
  if (word.empty()) return;
  diagnostic.fixes.push_back(
      {fmt::format("did you mean `{}`?", word), diagnostic.location, std::string(word)});
}

} // namespace proskill::syntax
