#include "ide/description/markup.h"

#include <algorithm>
#include <ranges>

namespace proskill::ide {

namespace {

/// Escapes user text, except backquotes.
std::string escaped(std::string_view text) {
  std::string result;
  bool inCode = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '`') inCode = !inCode;
    if (!inCode && std::string_view("\\*_[]<>#|").contains(c)) result += '\\';
    if (c == '\n' && i > 0) result += "  ";
    result += c;
  }
  return result;
}

std::string row(const std::vector<std::string>& cells) {
  std::string result = "|";
  for (const auto& cell : cells) result += " " + cell + " |";
  return result + "\n";
}

/// A fence that is longer than any row of backquotes in the text.
std::string fenceFor(std::string_view text) {
  std::string fence = "```";
  while (text.contains(fence)) fence += '`';
  return fence;
}

} // namespace

std::string withoutBackticks(std::string_view text) {
  std::string result(text);
  std::erase(result, '`');
  return result;
}

void Markup::add(std::string_view forMarkdown, std::string_view forPlain) {
  if (!inMarkdown.empty()) {
    inMarkdown += "\n\n";
    inPlain += "\n\n";
  }
  inMarkdown += forMarkdown;
  inPlain += forPlain;
}

void Markup::code(std::string_view program) {
  const auto fence = fenceFor(program);
  add(fence + "proskill\n" + std::string(program) + "\n" + fence, program);
}

void Markup::prose(std::string_view text) { add(escaped(text), withoutBackticks(text)); }

void Markup::table(const std::vector<std::vector<std::string>>& rows) {
  std::string markdown = row(rows.front());
  markdown += row(std::vector<std::string>(rows.front().size(), "---"));
  std::string plain;
  for (const auto& cells : rows | std::views::drop(1)) {
    markdown += row(cells);
    for (std::size_t i = 0; i < cells.size(); ++i)
      plain += (i == 0 ? "" : " -> ") + withoutBackticks(cells[i]);
    plain += '\n';
  }
  markdown.pop_back();
  if (!plain.empty()) plain.pop_back();
  add(markdown, plain);
}

} // namespace proskill::ide
