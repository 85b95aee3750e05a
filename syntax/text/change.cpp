#include "syntax/text/change.h"

#include "syntax/text/characters.h"

namespace proskill::syntax {
namespace {

/// Iterates over words; parentheses and other signs are words, too.
class Words {
public:
  explicit Words(std::string_view text) : text(text) { skip(); }

  [[nodiscard]] bool atEnd() const { return at == text.size(); }
  /// Whether white space or a comment precedes the word.
  [[nodiscard]] bool isApart() const { return apart; }
  [[nodiscard]] Offset begin() const { return static_cast<Offset>(at); }
  [[nodiscard]] std::string_view word() const { return text.substr(at, length()); }

  void next() {
    at += length();
    skip();
  }

private:
  /// Length up to white space or a comment; of a string, up to its closing quote or the end of the
  /// line.
  [[nodiscard]] std::size_t length() const {
    std::size_t end = at;
    bool inString = false;
    for (; end < text.size(); ++end) {
      const char c = text[end];
      if (c == '\n' || c == '\r' || (!inString && (isSpace(c) || c == ';'))) break;
      if (c == '"') inString = !inString;
      if (c == '\\' && inString && end + 1 < text.size() && text[end + 1] != '\n' &&
          text[end + 1] != '\r')
        ++end;
    }
    return end - at;
  }

  void skip() {
    const std::size_t before = at;
    while (at < text.size() && (isSpace(text[at]) || text[at] == ';'))
      at = text[at] == ';' ? std::min(text.find('\n', at), text.size()) : at + 1;
    apart = at != before;
  }

  std::string_view text;
  std::size_t at = 0;
  bool apart = false;
};

} // namespace

Range Replacement::nearest(Range range) const {
  const Offset by = newEnd - oldEnd;
  const Offset first = range.begin < begin ? range.begin : std::max(range.begin, oldEnd) + by;
  const Offset last = range.end > oldEnd ? range.end + by : std::min(range.end, begin);
  return {first, std::max(first, last)};
}

Replacement replacementOf(std::string_view before, std::string_view now) {
  const auto [front, back] = commonEnds(before, now);
  return {static_cast<Offset>(front), static_cast<Offset>(before.size() - back),
          static_cast<Offset>(now.size() - back)};
}

bool isLayout(std::string_view before, std::string_view now, const Replacement& edit) {
  Words old(before), fresh(now);
  for (; !old.atEnd() && !fresh.atEnd(); old.next(), fresh.next()) {
    const std::string_view word = old.word();
    if (word != fresh.word() || old.isApart() != fresh.isApart()) return false;
    const Offset begin = old.begin();
    auto moved = edit.moved({begin, begin + static_cast<Offset>(word.size())});
    if (!moved || moved->begin != fresh.begin()) return false;
  }
  return old.atEnd() && fresh.atEnd();
}

} // namespace proskill::syntax
