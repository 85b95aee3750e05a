#include "syntax/format/indent.h"

#include "syntax/text/characters.h"

#include <algorithm>
#include <array>

namespace proskill::syntax {

namespace {

template <std::size_t n>
bool isOneOf(std::string_view word, const std::array<std::string_view, n>& words) {
  return std::ranges::find(words, word) != words.end();
}

std::string_view firstWordIn(std::string_view line) {
  return line.substr(0, line.find_first_of(" \t();"));
}

/// An open parenthesis, and the words directly in it.
struct OpenForm {
  Offset at = 0;
  std::string_view before; ///< the word before the parenthesis
  std::vector<Range> items;
};

/// Reads the text up to a line, and records the forms that are open there.
class Reader {
public:
  explicit Reader(std::string_view text) : text(text) {}

  std::vector<OpenForm> run() {
    while (at < text.size()) {
      if (isSpace(text[at]))
        ++at;
      else if (text[at] == ';')
        at = std::min(text.find('\n', at), text.size());
      else
        token();
    }
    return std::move(open);
  }

private:
  void token() {
    if (text[at] == '(') {
      item({offset(at), offset(at + 1)});
      open.push_back({offset(at), word, {}});
      ++at;
    } else if (text[at] == ')') {
      ++at;
      if (open.empty()) return;
      open.pop_back();
      if (!open.empty()) open.back().items.back().end = offset(at);
    } else {
      auto end = endOfWord();
      item({offset(at), offset(end)});
      word = text.substr(at, end - at);
      at = end;
    }
  }

  void item(Range range) {
    if (!open.empty()) open.back().items.push_back(range);
  }

  [[nodiscard]] std::size_t endOfWord() const {
    auto end = at + 1;
    if (text[at] != '"') {
      while (end < text.size() && !isSpace(text[end]) &&
             !std::string_view("();\"").contains(text[end]))
        ++end;
      return end;
    }
    while (end < text.size() && text[end] != '"' && text[end] != '\n')
      end += text[end] == '\\' ? 2 : 1;
    return std::min(end + 1, text.size());
  }

  static Offset offset(std::size_t at) { return static_cast<Offset>(at); }

  std::string_view text;
  std::size_t at = 0;
  std::string_view word;
  std::vector<OpenForm> open;
};

/// The column of each part of a form, by the rules of the formatter.
class Rules {
public:
  Rules(std::string_view text, const OpenForm& form) : text(text), form(form) {}

  /// \param line without white space at its beginning
  [[nodiscard]] std::uint32_t indentation(std::string_view line) const {
    std::uint32_t base = columnOf(form.at);
    if (form.items.empty()) return base + 1;
    auto head = wordOf(form.items.front());
    bool behindKeyword = wordOf(form.items.back()).starts_with(':');
    if (head.starts_with("def"))
      return base + (behindKeyword || (behindTag() && line.starts_with('(')) ? 4 : 2);
    if (isOneOf(head, kControl)) return base + (isOneOf(firstWordIn(line), kClauses) ? 1 : 3);
    if (head.starts_with(':')) return base + (behindKeyword ? 3 : 1);
    bool isList = head.starts_with('(') || isOneOf(form.before, kLists);
    if (isList || form.items.size() < 2) return base + 1;
    return columnOf(form.items[1].begin);
  }

private:
  static constexpr std::array<std::string_view, 5> kControl{"if", "case", "while", "do",
                                                            "do-until"};
  static constexpr std::array<std::string_view, 3> kClauses{"else", "elseif", "until"};
  static constexpr std::array<std::string_view, 2> kOutcomes{":success", ":failure"};
  static constexpr std::array<std::string_view, 8> kLists{
      ":states",       ":transitions", ":input",   ":resources",
      ":precondition", ":invariant",   ":success", ":failure"};

  /// Whether the last item is the tag of an outcome, whose clause follows.
  [[nodiscard]] bool behindTag() const {
    const auto count = form.items.size();
    return count >= 2 && isOneOf(wordOf(form.items[count - 2]), kOutcomes) &&
           !wordOf(form.items.back()).starts_with('(');
  }

  [[nodiscard]] std::string_view wordOf(Range item) const {
    return text.substr(item.begin, item.length());
  }
  [[nodiscard]] std::uint32_t columnOf(Offset at) const {
    auto lineEnd = text.substr(0, at).rfind('\n');
    auto line = text.substr(lineEnd + 1, at - lineEnd - 1); // if there is no line end, npos + 1 is
                                                            // 0
    return widthOf(line);
  }

  std::string_view text;
  const OpenForm& form;
};

} // namespace

std::uint32_t indentation(std::string_view above, std::string_view line) {
  auto open = Reader(above).run();
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  return open.empty() ? 0 : Rules(above, open.back()).indentation(line);
}

Range regionAt(const Document& document, Offset at) {
  Range found;
  for (const Region& region : document.regions())
    if (region.range.begin < at || at == 0) found = region.range;
  return found;
}

} // namespace proskill::syntax
