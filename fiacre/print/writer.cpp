#include "fiacre/print/writer.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace proskill::fiacre {
namespace {

/// How suitable a position is for a line break.
enum class Break : std::uint8_t { Good, Poor, None };

Break breakAt(std::string_view text, std::size_t space) {
  if (text[space] != ' ') return Break::None;
  const auto before = text.substr(0, space);
  for (std::string_view end : {",", " and", " or", " |", " ||", ":=", " =>", " ?", " :"})
    if (before.ends_with(end)) return Break::Good;
  return Break::Poor;
}

/// The position of a line break: the last good one within `room` bytes, else the last poor one,
/// else the first one after them.
std::optional<std::size_t> chooseBreak(std::string_view text, std::size_t room) {
  std::optional<std::size_t> good;
  std::optional<std::size_t> poor;
  for (std::size_t at = 1; at < text.size(); ++at) {
    if (at > room && (good || poor)) break;
    const auto quality = breakAt(text, at);
    if (quality == Break::Good) good = at;
    if (quality == Break::Poor) poor = at;
  }
  return good ? good : poor;
}

/// The columns after the parentheses that are open at the end of a text.
class OpenParentheses {
public:
  explicit OpenParentheses(std::size_t hang) : base(hang) {}

  void read(std::string_view text, std::size_t column) {
    for (char c : text) {
      ++column;
      if (c == '(' || c == '{') columns.push_back(column);
      if ((c == ')' || c == '}') && !columns.empty()) columns.pop_back();
    }
  }
  /// The column of the next line, limited so that enough space remains on it.
  [[nodiscard]] std::size_t column() const {
    constexpr std::size_t kFurthest = 60;
    return columns.empty() || columns.back() > kFurthest ? base : columns.back();
  }

private:
  std::size_t base;
  std::vector<std::size_t> columns;
};

std::string_view trimRight(std::string_view text) {
  const auto last = text.find_last_not_of(" \t\r");
  return last == std::string_view::npos ? std::string_view{} : text.substr(0, last + 1);
}

std::vector<std::string_view> splitLines(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find_first_of("\n\r", begin), text.size());
    lines.push_back(trimRight(text.substr(begin, end - begin)));
    begin = end + (text.substr(end).starts_with("\r\n") ? 2 : 1);
  }
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  return lines;
}

} // namespace

void Writer::put(std::size_t indent, std::string_view line) {
  line = trimRight(line);
  if (!line.empty()) text.append(indent, ' ').append(line);
  text += '\n';
  ++count;
}

void Writer::blank() {
  if (!text.empty() && !text.ends_with("\n\n")) put(0, {});
}

void Writer::comment(std::size_t indent, std::string_view comment) {
  for (auto line : splitLines(comment)) {
    while (indent + 3 + line.size() > kWidth) {
      const auto space = line.rfind(' ', kWidth - indent - 3);
      if (space == std::string_view::npos || space == 0) break;
      put(indent, "// " + std::string(line.substr(0, space)));
      line.remove_prefix(space + 1);
    }
    put(indent, "// " + std::string(line));
  }
}

void Writer::line(std::size_t indent, std::string_view line, std::string_view note,
                  std::size_t hang) {
  const bool oneLine = note.find_first_of("\n\r") == std::string_view::npos;
  if (!note.empty() && oneLine && indent + line.size() + 4 + note.size() <= kWidth)
    return put(indent, std::string(line) + " // " + std::string(note));
  comment(indent, note);

  OpenParentheses open(indent + hang);
  while (indent + line.size() > kWidth) {
    const auto at = chooseBreak(line, kWidth - indent);
    if (!at) break;
    put(indent, line.substr(0, *at));
    open.read(line.substr(0, *at), indent);
    line.remove_prefix(*at + 1);
    indent = open.column();
  }
  put(indent, line);
}

} // namespace proskill::fiacre
