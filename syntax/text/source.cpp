#include "syntax/text/source.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <cstring>

namespace proskill::syntax {

LineIndex::LineIndex(std::string_view text) : size(static_cast<Offset>(text.size())) {
  add(text, 0);
}

LineIndex LineIndex::edited(Range range, std::string_view put) const {
  const auto behind = static_cast<Offset>(put.size()) - range.length(); // may wrap around
  const auto first = std::ranges::upper_bound(starts, range.begin);
  const auto kept = std::upper_bound(first, starts.end(), range.end);
  LineIndex result;
  result.size = size + behind;
  result.starts.reserve(starts.size() + static_cast<std::size_t>(std::ranges::count(put, '\n')));
  result.starts.assign(starts.begin(), first);
  result.add(put, range.begin);
  for (auto at = kept; at != starts.end(); ++at) result.starts.push_back(*at + behind);
  return result;
}

void LineIndex::add(std::string_view text, Offset at) {
  const char* const end = text.data() + text.size();
  for (const char* next = text.data(); next != end;) {
    const void* found = std::memchr(next, '\n', static_cast<std::size_t>(end - next));
    if (!found) break;
    next = static_cast<const char*>(found) + 1;
    starts.push_back(at + static_cast<Offset>(next - text.data()));
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

std::string digestOf(std::string_view text) {
  const XXH128_hash_t digest = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", digest.high64, digest.low64);
}

} // namespace proskill::syntax
