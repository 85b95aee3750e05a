#include "fiacre/format/line_builder.h"

#include "fiacre/syntax/words.h"

namespace proskill::fiacre {

LineBuilder::LineBuilder(std::string_view read, const std::vector<Token>& tokens)
    : text(read), all(tokens) {
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!isComment(all[i])) words.push_back(i);
}

void LineBuilder::start(std::size_t indent, std::string_view lead, std::size_t leadWidth) {
  ended = true;
  takeComments();
  ended = false;
  FormatLine line{.indent = indent, .lead = std::string(lead), .leadWidth = leadWidth};
  line.blank = blankBefore(words[at]);
  lines.push_back(std::move(line));
}

void LineBuilder::take() {
  if (ended && depth == 0 && previous()) start(lines.empty() ? 0 : lines.back().indent);
  if (lines.empty()) start(0);
  takeComments();
  const bool interval = (isAt("[") || isAt("]")) && previous() && isBeforeInterval();
  if (!interval) return takeOne();
  while (!isAt(",")) takeOne();
  while (!isAt("[") && !isAt("]")) takeOne();
  takeOne();
  depth = 0;
}

bool LineBuilder::isBeforeInterval() const {
  return isAmong(previous()->text,
                 std::to_array<std::string_view>({"wait", "in", "within", "interval"}));
}

void LineBuilder::takeOne() {
  takeComments();
  const Token& token = peek();
  lines.back().tokens.push_back(token);
  noteDepth(token);
  ++at;
}

void LineBuilder::noteDepth(const Token& token) {
  constexpr auto kOpening = std::to_array<std::string_view>({"(", "[", "{", "{|"});
  constexpr auto kClosing = std::to_array<std::string_view>({")", "]", "}", "|}"});
  if (token.kind != TokenKind::Symbol) return;
  if (isAmong(token.text, kOpening)) ++depth;
  if (isAmong(token.text, kClosing) && depth > 0) --depth;
}

std::size_t LineBuilder::newlinesBefore(std::size_t index) const {
  const auto from = index == 0 ? 0 : all[index - 1].end();
  const auto gap = text.substr(from, all[index].begin - from);
  return static_cast<std::size_t>(std::ranges::count(gap, '\n'));
}

std::size_t LineBuilder::column(const Token& token) const {
  constexpr std::size_t kFar = 1000;
  const auto before = text.substr(token.begin - std::min<std::size_t>(token.begin, kFar),
                                  std::min<std::size_t>(token.begin, kFar));
  return before.size() - (before.rfind('\n') + 1); // if there is no line end, npos + 1 is 0
}

void LineBuilder::takeComments() {
  for (auto i = at == 0 ? 0 : words[at - 1] + 1; i < words[at]; ++i) {
    if (i < taken) continue;
    taken = i + 1;
    const bool trails = newlinesBefore(i) == 0 && !lines.empty();
    if (!ended || (trails && lines.back().shape != FormatLine::Shape::Comment))
      lines.back().tokens.push_back(all[i]);
    else
      lines.push_back({.shape = FormatLine::Shape::Comment,
                       .indent = commentIndent(i),
                       .blank = blankBefore(i),
                       .tokens = {all[i]}});
  }
}

std::size_t LineBuilder::lastTouching(std::size_t i) {
  if (touching && i <= *touching) return *touching;
  auto last = i;
  while (isComment(all[last + 1]) && newlinesBefore(last + 1) == 1) ++last;
  touching = last;
  return last;
}

void LineBuilder::separate() {
  auto line = lines.size() - 1;
  while (line > 0 && !lines[line].blank && lines[line - 1].shape == FormatLine::Shape::Comment)
    --line;
  lines[line].blank = true;
}

bool isLineBreak(std::string_view text, const Token& before, const Token& after) {
  return text.substr(before.end(), after.begin - before.end()).contains('\n');
}

} // namespace proskill::fiacre
