#include "analysis/flow/domain/values.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <set>

namespace proskill::analysis::flow {

namespace {

constexpr std::int64_t kMostClasses = 64;

std::vector<Span> oneEach(std::int64_t min, std::int64_t max) {
  std::vector<Span> classes;
  for (std::int64_t number = min; number <= max; ++number) classes.push_back({number, number});
  return classes;
}

/// Splits a range into classes that begin at `starts`; halves the number of starts while there are
/// too many.
std::vector<Span> cutAt(std::int64_t min, std::int64_t max, const std::set<std::int64_t>& starts) {
  std::vector<std::int64_t> kept(starts.begin(), starts.end());
  while (std::ssize(kept) > kMostClasses) {
    std::vector<std::int64_t> half;
    for (std::size_t i = 0; i < kept.size(); i += 2) half.push_back(kept[i]);
    kept = std::move(half);
  }
  std::vector<Span> classes;
  for (std::size_t i = 0; i < kept.size(); ++i)
    classes.push_back({kept[i], i + 1 < kept.size() ? kept[i + 1] - 1 : max});
  assert(!classes.empty() && classes.front().first == min);
  return classes;
}

} // namespace

Domain Domain::ofNumbers(std::int64_t min, std::int64_t max, std::span<const std::int64_t> cuts) {
  assert(min <= max);
  Domain domain;
  if (static_cast<std::uint64_t>(max) - static_cast<std::uint64_t>(min) < kMostClasses) {
    domain.classes = oneEach(min, max);
    return domain;
  }
  std::set<std::int64_t> starts{min, min + 1, max};
  for (std::int64_t cut : cuts) {
    if (cut > min && cut <= max) starts.insert(cut);
    if (cut >= min && cut < max) starts.insert(cut + 1);
  }
  domain.classes = cutAt(min, max, starts);
  return domain;
}

Domain Domain::ofWords(std::vector<std::string_view> words) {
  assert(!words.empty());
  std::vector<std::int64_t> everywhere(words.size());
  std::iota(everywhere.begin(), everywhere.end(), 0);
  Domain domain = ofNumbers(0, std::ssize(words) - 1, everywhere);
  domain.words = std::move(words);
  return domain;
}

std::optional<std::int64_t> Domain::numberOf(std::string_view word) const {
  auto found = std::ranges::find(words, word);
  if (found == words.end()) return std::nullopt;
  return found - words.begin();
}

ValueSet Domain::touching(Span span) const {
  ValueSet touched;
  for (unsigned i = 0; i < size(); ++i)
    if (classes[i].first <= span.last && span.first <= classes[i].last) touched |= ValueSet::of(i);
  return touched;
}

ValueSet Domain::saturated(Span span) const {
  return touching({std::clamp(span.first, min(), max()), std::clamp(span.last, min(), max())});
}

} // namespace proskill::analysis::flow
