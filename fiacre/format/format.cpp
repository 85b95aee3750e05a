#include "fiacre/format/format.h"

#include "fiacre/format/format_lines.h"
#include "fiacre/syntax/parse.h"

#include <algorithm>
#include <cassert>

namespace proskill::fiacre {

std::optional<std::string> format(std::string_view text) {
  const auto tokens = tokenizeWithComments(text);
  if (!parse(text).problems.empty()) return std::nullopt;
  const std::string mark(text.starts_with(kByteOrderMark) ? kByteOrderMark : "");
  return mark + writeLines(text, splitLines(text, tokens));
}

std::optional<std::vector<Change>> formatChanges(std::string_view text) {
  const auto laidOut = format(text);
  if (!laidOut) return std::nullopt;
  const auto before = tokenizeWithComments(text);
  const auto after = tokenizeWithComments(*laidOut);
  const bool same = std::ranges::equal(before, after, {}, &Token::text, &Token::text);
  assert(same);
  if (!same) return std::nullopt;
  std::vector<Change> changes;
  std::uint32_t oldEnd = 0;
  std::uint32_t newEnd = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    auto gap = laidOut->substr(newEnd, after[i].begin - newEnd);
    if (text.substr(oldEnd, before[i].begin - oldEnd) != gap)
      changes.push_back({oldEnd, before[i].begin, std::move(gap)});
    oldEnd = before[i].end();
    newEnd = after[i].end();
  }
  return changes;
}

} // namespace proskill::fiacre
