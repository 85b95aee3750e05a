#include "ide/completion/fuzzy.h"

#include <algorithm>
#include <vector>

namespace proskill::ide {

namespace {

constexpr int kNever = -1'000'000;
constexpr std::size_t kLongest = 128; ///< longer names are cut here

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }

/// Score of a letter at its position, without its neighbours.
int worth(std::string_view name, std::size_t at) {
  if (at == 0) return 8;
  const char before = name[at - 1];
  if (before == '_' || before == '.' || before == ':' || before == '$' || before == '/') return 6;
  return isUpper(name[at]) && !isUpper(before) ? 6 : 1;
}

} // namespace

/// The best score of all ways to find the typed letters, by dynamic programming: `ends[j]` is the
/// best of those that end with letter j of the name.
std::optional<int> fuzzyScore(std::string_view typed, std::string_view name) {
  if (typed.empty()) return 0;
  name = name.substr(0, kLongest);
  if (typed.size() > name.size()) return std::nullopt;
  std::vector<int> ends(name.size(), 0);
  for (std::size_t i = 0; i < typed.size(); ++i) {
    std::vector<int> next(name.size(), kNever);
    int best = i == 0 ? 0 : kNever; // of the ways that end before j
    for (std::size_t j = 0; j < name.size(); ++j) {
      if (j > 0 && i > 0) best = std::max(best, ends[j - 1]);
      if (lower(name[j]) != lower(typed[i])) continue;
      const bool follows = i > 0 && j > 0 && ends[j - 1] > kNever / 2;
      const int exact = name[j] == typed[i] ? 1 : 0;
      next[j] = best + worth(name, j) + exact;
      if (follows) next[j] = std::max(next[j], ends[j - 1] + 7 + exact);
    }
    ends = std::move(next);
  }
  const int score = std::ranges::max(ends);
  if (score < 0) return std::nullopt;
  return score * 4 - static_cast<int>(std::min<std::size_t>(name.size() - typed.size(), 40)) / 2;
}

} // namespace proskill::ide
