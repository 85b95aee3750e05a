#include "report/text/snippet.h"

#include "report/text/text_width.h"
#include "syntax/text/utf8.h"

#include <algorithm>
#include <ostream>
#include <tuple>

namespace proskill::report {

using syntax::Offset;
using syntax::Range;

namespace {

/// Limits of longer lines: bytes shown before a mark, and in all.
constexpr Offset kBeforeMark = 60;
constexpr Offset kWindow = 240;

/// Moves forward to the start of a character.
Offset toCharacter(std::string_view text, Offset at) {
  while (at < text.size() && syntax::continuesCharacter(text[at])) ++at;
  return at;
}

/// Text with a colour for each column; escape sequences are added at the end.
class Canvas {
public:
  void put(std::size_t column, std::string_view text, Colour colour) {
    if (text.empty()) return;
    pieces.push_back({column, std::string(text), colour});
  }

  /// Appends the pieces from left to right. They must not overlap.
  [[nodiscard]] std::string str(const Paint& paint) const {
    auto ordered = pieces;
    std::ranges::stable_sort(ordered, {}, &Piece::column);
    std::string line;
    std::size_t at = 0;
    for (const Piece& piece : ordered) {
      if (piece.column > at) line.append(piece.column - at, ' ');
      line += paint(piece.colour, piece.text);
      at = std::max(at, piece.column) + DisplayedLine(piece.text).column(piece.text.size());
    }
    return line;
  }

private:
  struct Piece {
    std::size_t column;
    std::string text;
    Colour colour;
  };
  std::vector<Piece> pieces;
};

/// A mark below a displayed line, in columns.
struct Underline {
  std::size_t begin;
  std::size_t end;
  const std::string* label;
  bool primary;
};

/// The rows below a line: the underlines with the label of the last one, then the other labels from
/// right to left, each below its mark.
class Underlines {
public:
  Underlines(std::vector<Underline> marks, Colour primary)
      : marks(std::move(marks)), primary(primary) {
    std::ranges::stable_sort(this->marks, {},
                             [](const Underline& it) { return std::tuple(it.begin, it.end); });
  }

  [[nodiscard]] std::vector<std::string> rows(const Paint& paint) const {
    std::vector<std::string> found{underlines(paint)};
    for (std::size_t i = marks.size(); i-- > 0;) {
      if (marks[i].label->empty() || i == inlineLabel()) continue;
      found.push_back(connectors(i + 1, nullptr, paint));
      found.push_back(connectors(i, &marks[i], paint));
    }
    return found;
  }

private:
  [[nodiscard]] Colour colour(const Underline& mark) const {
    return mark.primary ? primary : Colour::Blue;
  }

  /// The label of the last mark is beside it if nothing follows.
  [[nodiscard]] std::size_t inlineLabel() const {
    const Underline& last = marks.back();
    const bool free = std::ranges::none_of(
        marks, [&](const Underline& it) { return &it != &last && it.end > last.begin; });
    return free ? marks.size() - 1 : marks.size();
  }

  [[nodiscard]] std::string underlines(const Paint& paint) const {
    std::size_t end = 0;
    for (const Underline& mark : marks) end = std::max(end, mark.end);
    std::vector<const Underline*> top(end, nullptr); ///< primary marks hide the others
    for (bool wanted : {false, true})
      for (const Underline& mark : marks)
        if (mark.primary == wanted)
          std::fill(top.begin() + static_cast<std::ptrdiff_t>(mark.begin),
                    top.begin() + static_cast<std::ptrdiff_t>(mark.end), &mark);
    Canvas canvas;
    for (std::size_t i = 0; i < end;) {
      std::size_t next = i + 1;
      while (next < end && top[next] == top[i]) ++next;
      if (top[i])
        canvas.put(i, std::string(next - i, top[i]->primary ? '^' : '-'), colour(*top[i]));
      i = next;
    }
    if (inlineLabel() < marks.size())
      canvas.put(end + 1, *marks.back().label, colour(marks.back()));
    return canvas.str(paint);
  }

  /// Vertical bars below the labelled marks before `count`, then the label of `mark`.
  [[nodiscard]] std::string connectors(std::size_t count, const Underline* mark,
                                       const Paint& paint) const {
    Canvas canvas;
    std::size_t last = mark ? mark->begin : std::string::npos;
    for (std::size_t i = count; i-- > 0;) {
      if (marks[i].label->empty() || marks[i].begin == last) continue;
      canvas.put(marks[i].begin, "|", colour(marks[i]));
      last = marks[i].begin;
    }
    if (mark) canvas.put(mark->begin, *mark->label, colour(*mark));
    return canvas.str(paint);
  }

  std::vector<Underline> marks;
  Colour primary;
};

} // namespace

Snippet::Snippet(const syntax::Document& document, const std::vector<Mark>& marks)
    : document(document) {
  for (const Mark& mark : marks) add(mark);
  std::ranges::stable_sort(lines, {},
                           [](const Line& it) { return std::tuple(it.number, it.shown.begin); });
}

void Snippet::add(const Mark& mark) {
  const auto& index = document.lines();
  const std::string_view text = document.text();
  const auto first = index.position(mark.range.begin).line;
  auto last = index.position(mark.range.end).line;
  // a range that includes the line end ends there, not at the start of the next line
  if (last > first && index.offset({last, 0}) == mark.range.end) --last;
  if (first == last) return addPiece(first, {mark.range, mark.label, mark.primary});
  const Range begin = index.line(first, text), end = index.line(last, text);
  Offset indented = end.begin;
  while (indented < end.end && (text[indented] == ' ' || text[indented] == '\t')) ++indented;
  addPiece(first, {{mark.range.begin, begin.end}, "", mark.primary});
  addPiece(last, {{indented, std::min(mark.range.end, end.end)}, mark.label, mark.primary});
}

void Snippet::addPiece(std::uint32_t number, const Piece& piece) {
  for (Line& line : lines) {
    const bool inside =
        line.shown.begin <= piece.range.begin && piece.range.begin <= line.shown.end;
    if (line.number == number && inside) return line.pieces.push_back(piece);
  }
  const Range whole = document.lines().line(number, document.text());
  lines.push_back({number, windowAround(whole, piece.range), {piece}});
}

Range Snippet::windowAround(Range line, Range piece) const {
  if (line.length() <= kWindow) return line;
  const std::string_view text = document.text();
  Offset begin = line.begin;
  if (piece.begin - line.begin > kBeforeMark) begin = toCharacter(text, piece.begin - kBeforeMark);
  return {begin, line.end - begin > kWindow ? toCharacter(text, begin + kWindow) : line.end};
}

std::size_t Snippet::gutterWidth() const {
  std::size_t width = 1;
  for (const Line& line : lines) width = std::max(width, std::to_string(line.number + 1).size());
  return width;
}

void Snippet::print(std::ostream& out, std::size_t gutter, const Paint& paint,
                    Colour primary) const {
  const std::string_view text = document.text();
  const std::string bar = paint(Colour::Blue, std::string(gutter, ' ') + " |");
  out << bar << '\n';
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Line& line = lines[i];
    if (i > 0 && line.number > lines[i - 1].number + 1) out << paint(Colour::Blue, "...") << '\n';
    const Range whole = document.lines().line(line.number, text);
    const bool cutBefore = line.shown.begin > whole.begin, cutAfter = line.shown.end < whole.end;
    const DisplayedLine shown(text.substr(line.shown.begin, line.shown.length()));
    const std::string number = std::to_string(line.number + 1);
    const std::string label = std::string(gutter - number.size(), ' ') + number + " |";
    out << paint(Colour::Blue, label) << ' ' << (cutBefore ? "…" : "") << shown.text()
        << (cutAfter ? "…" : "") << '\n';
    std::vector<Underline> underlines;
    for (const Piece& piece : line.pieces) {
      const std::size_t shift = cutBefore ? 1 : 0;
      const std::size_t begin = shown.column(piece.range.begin - line.shown.begin) + shift;
      const std::size_t end = shown.column(piece.range.end - line.shown.begin) + shift;
      underlines.push_back({begin, std::max(end, begin + 1), &piece.label, piece.primary});
    }
    for (const std::string& row : Underlines(std::move(underlines), primary).rows(paint))
      out << bar << ' ' << row << '\n';
  }
}

} // namespace proskill::report
