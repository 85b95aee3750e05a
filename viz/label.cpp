#include "viz/label.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <utility>

namespace proskill::viz {
namespace {

constexpr std::size_t kPerRow = 4; ///< entries of the legend
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// The length in bytes of the character that a text begins with; 0 where it is no UTF-8.
std::size_t characterLength(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const auto lead = byte(0);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  // Neither too long, nor a surrogate, nor beyond Unicode.
  const bool bad =
      length > 2 && ((lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) > 0x9F) ||
                     (lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) > 0x8F));
  return bad ? 0 : length;
}

std::size_t countCharacters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<std::uint8_t>(c) & 0xC0) != 0x80; }));
}

/// What should stay on one line: a word, or all that is between parentheses where it is short
/// enough.
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

/// Each meaning once, in the order of the roles.
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

/// What the title is wider than a short legend goes into a cell of its own: the table would spread
/// it over all. Widths are guessed, in points, since the font is not known here.
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
  while (!text.empty()) {
    const auto length = characterLength(text);
    if (length == 0)
      out += kReplacement;
    else if (length == 1 && (static_cast<std::uint8_t>(text[0]) < 0x20 || text[0] == 0x7F))
      out += ' ';
    else
      out += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

std::string escape(std::string_view text) {
  std::string out;
  for (char c : clean(text)) {
    switch (c) {
    case '&': out += "&amp;"; break;
    case '<': out += "&lt;"; break;
    case '>': out += "&gt;"; break;
    case '"': out += "&quot;"; break;
    default: out += c;
    }
  }
  return out;
}

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
