#include "syntax/source.h"

#include <algorithm>
#include <cstring>

namespace proskill::syntax {

LineIndex::LineIndex(std::string_view text) : starts{0}, size(static_cast<Offset>(text.size())) {
  const char* end = text.data() + text.size();
  for (const char* at = text.data(); at != end;) {
    const void* found = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
    if (!found) break;
    at = static_cast<const char*>(found) + 1;
    starts.push_back(static_cast<Offset>(at - text.data()));
  }
}

Position LineIndex::position(Offset at) const {
  auto next = std::ranges::upper_bound(starts, at);
  auto line = static_cast<std::uint32_t>(next - starts.begin() - 1);
  return {line, at - starts[line]};
}

Position LineIndex::position(Offset at, std::uint32_t& line) const {
  constexpr std::uint32_t kNear = 32;
  const auto count = lineCount();
  const auto first = line > kNear ? line - kNear : 0;
  const auto last = std::min(count, line + kNear);
  const bool isNear = first < last && starts[first] <= at && (last == count || at < starts[last]);
  const auto begin = starts.begin() + (isNear ? first : 0);
  const auto end = starts.begin() + (isNear ? last : count);
  line = static_cast<std::uint32_t>(std::upper_bound(begin, end, at) - starts.begin() - 1);
  return {line, at - starts[line]};
}

Offset LineIndex::offset(Position position) const {
  if (position.line >= starts.size()) return size;
  Offset end = position.line + 1 < starts.size() ? starts[position.line + 1] - 1 : size;
  return starts[position.line] + std::min(position.column, end - starts[position.line]);
}

std::uint32_t LineIndex::lineCount() const { return static_cast<std::uint32_t>(starts.size()); }

Range LineIndex::line(std::uint32_t number, std::string_view text) const {
  Offset begin = starts[number];
  Offset end = number + 1 < starts.size() ? starts[number + 1] - 1 : size;
  if (end > begin && number + 1 < starts.size() && text[end - 1] == '\r') --end;
  return {begin, end};
}

} // namespace proskill::syntax
