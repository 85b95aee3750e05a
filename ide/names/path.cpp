#include "ide/names/path.h"

#include "ide/names/vocabulary.h"

#include <algorithm>
#include <array>

namespace proskill::ide {

namespace {

using syntax::Offset;

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool isBracket(char c) { return c == '[' || c == ']'; }
bool endsWord(char c) { return isSpace(c) || c == '(' || c == ')' || c == '"' || c == ';'; }

/// Keywords that occur directly in a definition only, even if parentheses before them are missing.
bool isFieldOfDefinition(std::string_view keyword) {
  constexpr std::array kInner{WordKind::InvariantField, WordKind::OutcomeField,
                              WordKind::PatternField};
  for (auto kind : kInner)
    if (findWord(kind, keyword)) return false;
  return findWord(WordKind::SkillField, keyword) || findWord(WordKind::VariableField, keyword);
}

/// Reads from the beginning of a form to the cursor.
class Reader {
public:
  Reader(std::string_view text, Offset begin, Offset cursor)
      : text(text), cursor(cursor), at(begin), lineHasToken(!atLineStart(begin)) {}

  Path read() {
    while (at < cursor && !found) step();
    if (!found) path.word = {cursor, wordEnd(cursor)};
    if (path.surrounding == Surrounding::Code) enterInterval();
    path.prefix = text.substr(path.word.begin, cursor - path.word.begin);
    return std::move(path);
  }

private:
  [[nodiscard]] bool atLineStart(Offset offset) const {
    return offset == 0 || text[offset - 1] == '\n';
  }

  [[nodiscard]] Offset wordEnd(Offset from) const {
    while (from < text.size() && !endsWord(text[from])) ++from;
    return from;
  }

  /// \pre called with ascending positions
  [[nodiscard]] Offset lineEnd(Offset from) {
    if (!lastLineEnd || from > *lastLineEnd) {
      auto end = text.find_first_of("\r\n", from);
      lastLineEnd = static_cast<Offset>(end == std::string_view::npos ? text.size() : end);
    }
    return *lastLineEnd;
  }

  void step() {
    switch (text[at]) {
    case ';': return comment();
    case '"': return string();
    case '(': return open();
    case ')': return close();
    case '\n': lineHasToken = false; [[fallthrough]];
    case ' ':
    case '\t':
    case '\r': ++at; return;
    default: return word();
    }
  }

  void comment() {
    auto end = lineEnd(at);
    if (cursor > at && cursor <= end) stopIn(Surrounding::Comment, {cursor, cursor});
    at = end;
  }

  void string() {
    auto end = at + 1;
    const auto last = lineEnd(at);
    while (end < last && text[end] != '"') end += text[end] == '\\' ? 2 : 1;
    end = std::min(end, last);
    if (cursor <= end) return stopIn(Surrounding::String, {at + 1, end});
    if (end < text.size() && text[end] == '"') ++end;
    add({at, end});
    at = end;
  }

  /// A list in the first column just before the cursor begins a new definition, whatever is open
  /// above it.
  void open() {
    if (atLineStart(at) && wordEnd(at + 1) >= cursor) path.lists.clear();
    path.lists.push_back({at, {}});
    lineHasToken = true;
    ++at;
  }

  void close() {
    ++at;
    lineHasToken = true;
    if (path.lists.empty()) return;
    const auto begin = path.lists.back().begin;
    path.lists.pop_back();
    if (!path.lists.empty()) path.lists.back().items.push_back({{begin, at}, {}});
  }

  void word() {
    auto end = wordEnd(at);
    if (end >= cursor) return stopIn(Surrounding::Code, {at, end});
    add({at, end});
    at = end;
  }

  void add(syntax::Range range) {
    if (path.lists.empty()) return;
    Item item{range, text.substr(range.begin, range.length()), !lineHasToken};
    lineHasToken = true;
    if (item.startsLine && isFieldOfDefinition(item.text)) path.lists.resize(1);
    path.lists.back().items.push_back(item);
  }

  /// Between brackets the word is a bound alone.
  void enterInterval() {
    const auto before = text.substr(0, cursor);
    const auto start = before.find_last_of("\n();\"");
    const auto line = before.substr(start == std::string_view::npos ? 0 : start);
    const bool isOperator = line.starts_with("([");
    if (isOperator || std::ranges::count_if(line, isBracket) % 2 == 0) return;
    path.isInInterval = true;
    constexpr std::string_view kSigns = "[],";
    const auto last = static_cast<Offset>(before.find_last_of(kSigns)) + 1;
    path.word.begin = std::max(path.word.begin, last);
    const auto next = text.substr(cursor, path.word.end - cursor).find_first_of(kSigns);
    if (next != std::string_view::npos) path.word.end = cursor + static_cast<Offset>(next);
  }

  void stopIn(Surrounding surrounding, syntax::Range word) {
    path.surrounding = surrounding;
    path.word = word;
    found = true;
  }

  std::string_view text;
  Offset cursor;
  Offset at;
  bool lineHasToken;
  std::optional<Offset>
      lastLineEnd; ///< of the line of a string or a comment, kept since a line may have thousands
  bool found = false;
  Path path;
};

} // namespace

const syntax::Form* formBefore(const syntax::Document& document, Offset at) {
  const auto& forms = document.forms();
  auto after = std::ranges::upper_bound(forms, at, std::ranges::less_equal(),
                                        [](const syntax::Form& form) { return form.range.begin; });
  return after == forms.begin() ? nullptr : &*std::prev(after);
}

Path pathTo(const syntax::Document& document, Offset at) {
  const auto* form = formBefore(document, at);
  return Reader(document.text(), form ? form->range.begin : 0, at).read();
}

} // namespace proskill::ide
