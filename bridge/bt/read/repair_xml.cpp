#include "bridge/bt/read/repair_xml.h"

#include <algorithm>
#include <array>

namespace proskill::bridge::bt {
namespace {

/// Whether a text begins with an entity that XML knows, or with the number of a character.
bool isEntity(std::string_view text) {
  constexpr auto kNamed =
      std::to_array<std::string_view>({"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"});
  if (text.starts_with("&#")) return text.substr(0, 12).find(';') != std::string_view::npos;
  return std::ranges::any_of(kNamed, [&](auto name) { return text.starts_with(name); });
}

class Repair {
public:
  explicit Repair(std::string_view text) : text(text) {}

  RepairedXml repair() {
    declaration();
    while (at < text.size()) {
      if (comes("<!--"))
        comment();
      else if (comes("<![CDATA["))
        copyTo("]]>");
      else if (comes("<?"))
        copyTo("?>");
      else if (comes("<"))
        tag();
      else
        character();
    }
    return std::move(result);
  }

private:
  [[nodiscard]] bool comes(std::string_view word) const {
    return text.substr(at).starts_with(word);
  }

  /// A declaration after white space becomes white space, too.
  void declaration() {
    const auto begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    if (begin == 0 || !text.substr(begin).starts_with("<?xml ")) return;
    const auto end = text.find("?>", begin);
    if (end == std::string_view::npos) return;
    for (; at < end + 2; ++at) result.text += text[at] == '\n' ? '\n' : ' ';
  }

  void copy() { result.text += text[at++]; }

  void copyTo(std::string_view end) {
    const auto found = text.find(end, at);
    const auto stop = found == std::string_view::npos ? text.size() : found + end.size();
    result.text += text.substr(at, stop - at);
    at = stop;
  }

  /// Of two hyphens, one becomes a space.
  void comment() {
    const auto begin = result.text.size() + 4;
    copyTo("-->");
    if (result.text.size() < begin + 3) return;
    const auto end = result.text.size() - 3;
    for (auto i = begin; i < end; ++i)
      if (result.text[i] == '-' && result.text[i + 1] == '-') result.text[i] = ' ';
  }

  void tag() {
    for (copy(); at < text.size() && text[at] != '>';)
      if (text[at] == '"' || text[at] == '\'')
        value(text[at]);
      else
        copy();
  }

  void value(char quote) {
    for (copy(); at < text.size() && text[at] != quote;) character();
    if (at < text.size()) copy();
  }

  void character() {
    const bool isBare = text[at] == '<' || (text[at] == '&' && !isEntity(text.substr(at)));
    if (!isBare) return copy();
    for (const char c : text[at++] == '<' ? std::string_view("&lt;") : std::string_view("&amp;")) {
      result.text += c;
      if (c != '&') result.added.push_back(result.text.size() - 1);
    }
  }

  std::string_view text;
  RepairedXml result;
  std::size_t at = 0;
};

} // namespace

RepairedXml repairXml(std::string_view text) { return Repair(text).repair(); }

} // namespace proskill::bridge::bt
