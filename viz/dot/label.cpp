#include "viz/dot/label.h"

#include "syntax/text/utf8.h"
#include "syntax/text/xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <utility>

namespace proskill::viz {
namespace {

constexpr std::size_t kPerRow = 4; ///< entries of the legend per row

using syntax::countCharacters;

/// The length of the next unbreakable unit: a word, or a short parenthesised expression.
std::size_t unitLength(std::string_view text, std::size_t width) {
  const auto word = std::min(text.find(' '), text.size());
  std::size_t depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '(') ++depth;
    if (text[at] == ')' && depth > 0) --depth;
    if (text[at] == ' ' && depth == 0)
      return countCharacters(text.substr(0, at)) <= width ? at : word;
  }
  return countCharacters(text) <= width ? text.size() : word;
}

/// An entry of the legend. Each meaning is shown once, in the order of the roles.
struct LegendEntry {
  std::string_view meaning;
  std::string cell;
};

std::vector<LegendEntry> legend(const Graph& graph, Scheme scheme) {
  std::set<NodeRole> nodes;
  for (const auto& node : graph.nodes) nodes.insert(node.role);
  std::set<EdgeRole> edges;
  for (const auto& edge : graph.edges) edges.insert(edge.role);
  std::vector<LegendEntry> entries;
  for (auto role : nodes) {
    const auto style = nodeStyle(role, scheme);
    if (style.meaning.empty()) continue;
    entries.push_back(
        {style.meaning,
         fmt::format(
             R"(<td width="14" height="11" fixedsize="true" border="1" color="{}" bgcolor="{}"></td>)",
             style.line, style.fill)});
  }
  for (auto role : edges) {
    const auto style = edgeStyle(role, scheme);
    if (style.meaning.empty()) continue;
    entries.push_back(
        {style.meaning, fmt::format(R"(<td><font color="{}" point-size="13">{}</font></td>)",
                                    style.colour, style.sign)});
  }
  return entries;
}

std::string headLine(std::string_view text, std::size_t columns, std::string_view font,
                     std::string_view tag) {
  return fmt::format(
      R"(<tr><td colspan="{0}" align="left"><font {1}><{2}>{3}</{2}></font></td></tr>)", columns,
      font, tag, escape(text));
}

/// An extra cell that fills the space between a short legend and a wider title; otherwise the table
/// would distribute it over all cells. Widths are estimated in points, since the font is unknown
/// here.
std::string filler(const Graph& graph, const std::vector<LegendEntry>& entries) {
  constexpr std::size_t kTitleCharacter = 10;
  constexpr std::size_t kLegendCharacter = 5;
  constexpr std::size_t kSwatch = 24;
  std::size_t width = countCharacters(graph.title) * kTitleCharacter;
  for (std::size_t column = 0; column < std::min(kPerRow, entries.size()); ++column) {
    std::size_t longest = 0;
    for (std::size_t i = column; i < entries.size(); i += kPerRow)
      longest = std::max(longest, countCharacters(entries[i].meaning));
    width -= std::min(width, kSwatch + longest * kLegendCharacter);
  }
  return fmt::format(R"(<td width="{}"></td>)", width);
}

} // namespace

std::string clean(std::string_view text) {
  std::string out;
  syntax::forEachCharacter(text, [&](char32_t character, std::string_view bytes) {
    out += character < 0x20 || character == 0x7F ? " " : bytes;
  });
  return out;
}

std::string escape(std::string_view text) { return syntax::xmlText(clean(text)); }

std::vector<std::string> wrap(std::string_view text, std::size_t width) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const auto word = text.substr(0, unitLength(text, width));
    if (!line.empty() && countCharacters(line) + 1 + countCharacters(word) > width)
      lines.push_back(std::exchange(line, {}));
    if (!line.empty()) line += ' ';
    line += word;
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

std::string nodeLabel(const Node& node, Scheme scheme) {
  constexpr std::size_t kHeadWidth = 30;
  constexpr std::size_t kDetailWidth = 44;
  std::string head;
  for (const auto& line : wrap(node.label, kHeadWidth))
    head += fmt::format("{}<b>{}</b>", head.empty() ? "" : "<br/>", escape(line));
  if (node.details.empty()) return head;
  std::string rows = fmt::format("<tr><td>{}</td></tr>", head);
  for (const auto& detail : node.details)
    for (const auto& line : wrap(detail, kDetailWidth))
      rows += fmt::format(R"(<tr><td><font point-size="9" color="{}">{}</font></td></tr>)",
                          pageStyle(scheme).faint, escape(line));
  return fmt::format(
      R"(<table border="0" cellborder="0" cellspacing="0" cellpadding="1">{}</table>)", rows);
}

std::string titleAndLegend(const Graph& graph, Scheme scheme) {
  const auto page = pageStyle(scheme);
  const auto entries = legend(graph, scheme);
  const auto columns = 2 * std::min(kPerRow, entries.size()) + 1;
  std::string out = R"(<table border="0" cellborder="0" cellspacing="3" cellpadding="1">)";
  out +=
      headLine(graph.title, columns, fmt::format(R"(point-size="15" color="{}")", page.text), "b");
  if (!graph.note.empty())
    out += headLine(graph.note, columns, fmt::format(R"(point-size="10" color="{}")", page.faint),
                    "i");
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i % kPerRow == 0) out += "<tr>";
    out += fmt::format(R"({}<td align="left"><font point-size="9" color="{}">{}  </font></td>)",
                       entries[i].cell, page.faint, entries[i].meaning);
    if (i == std::min(kPerRow, entries.size()) - 1) out += filler(graph, entries);
    if (i % kPerRow == kPerRow - 1 || i + 1 == entries.size()) out += "</tr>";
  }
  return out + "</table>";
}

} // namespace proskill::viz
