#include "syntax/format/format_layout.h"

#include "syntax/text/characters.h"

#include <algorithm>

namespace proskill::syntax {

std::uint32_t Layout::columnIn(Offset at) const {
  auto before = text.substr(0, at);
  return widthOf(before.substr(before.rfind('\n') + 1)); // if there is no line end, npos + 1 is 0
}

void Layout::leave(Range region) {
  previousEnd = region.end;
  frozen = true;
  lineMustEnd = false;
  lastWasForm = false;
}

void Layout::finish() {
  alignTrailing();
  if (frozen) return;
  auto end = static_cast<Offset>(text.size());
  bool empty = gaps.empty();
  gaps.push_back({{previousEnd, end}, empty ? 0U : 1U, 0});
}

void Layout::comment(Index at, std::uint32_t indent) {
  const Box& box = (*boxes)[at];
  bool trails =
      (!gaps.empty() || frozen) && !lineMustEnd && !lineEndsIn(text, previousEnd, box.range.begin);
  auto reached = widest;
  if (trails && !frozen)
    trailing.push_back({gaps.size(), written, column, columnIn(box.range.begin)});
  token(box.range, trails ? space(indent) : line(indent));
  widest = reached; // a comment is never broken, so it does not break its surroundings either
  lineMustEnd = true;
}

void Layout::token(Range range, Separator before) {
  using Kind = Separator::Kind;
  bool newLine = before.kind == Kind::Line || lineMustEnd;
  column = columnOf(before);
  Gap gap{{previousEnd, range.begin}, 0, column};
  if (newLine)
    gap.lines = linesBefore(range.begin);
  else
    gap.spaces = before.kind == Kind::Space ? 1 : 0;
  if (gaps.empty() && !frozen) gap.lines = 0;
  written += gap.lines;
  if (!frozen) gaps.push_back(gap);
  frozen = false;
  lineMustEnd = false;
  column += widthOf(text.substr(range.begin, range.length()));
  widest = std::max(widest, column);
  previousEnd = range.end;
}

/// Number of line ends to write: those that the user wrote, but at most two. There is no empty line
/// after an opening parenthesis.
std::uint32_t Layout::linesBefore(Offset token) const {
  auto old = text.substr(previousEnd, token - previousEnd);
  bool behindOpening = previousEnd > 0 && text[previousEnd - 1] == '(' && !lineMustEnd;
  return !behindOpening && std::ranges::count(old, '\n') > 1 ? 2 : 1;
}

/// Continues the line, unless it ends with a comment.
void Layout::close(Index at, std::uint32_t indent) {
  Offset end = (*boxes)[at].range.end;
  bool alone = lineMustEnd;
  token({end - 1, end}, none(indent));
  if (alone && !gaps.empty()) gaps.back().lines = 1;
}

std::uint32_t Layout::columnOf(Separator before) const {
  if (before.kind == Separator::Kind::Line || lineMustEnd) return before.indent;
  return column + (before.kind == Separator::Kind::Space ? 1 : 0);
}

/// Keeps trailing comments of consecutive lines aligned if they were aligned.
void Layout::alignTrailing() {
  for (std::size_t begin = 0, end = 0; begin < trailing.size(); begin = end) {
    std::uint32_t widestCode = 0;
    for (end = begin;
         end < trailing.size() && trailing[end].row == trailing[begin].row + (end - begin) &&
         trailing[end].sourceColumn == trailing[begin].sourceColumn;
         ++end)
      widestCode = std::max(widestCode, trailing[end].column);
    for (auto i = begin; i < end; ++i)
      gaps[trailing[i].gap].spaces = widestCode + 1 - trailing[i].column;
  }
}

} // namespace proskill::syntax
