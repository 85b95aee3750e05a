#include "syntax/text/scan.h"

#include "syntax/text/characters.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace proskill::syntax {
namespace {

// Keywords that occur at a single depth only; `:effects`, for example, is not one of them.
constexpr std::array<std::string_view, 18> kFields = {
    ":init",          ":min",       ":max",       ":states", ":transitions",   ":capacity",
    ":input",         ":start",     ":invariant", ":action", ":interrupt",     ":precondition",
    ":time_interval", ":resources", ":monitor",   ":body",   ":interruptible", ":every",
};

std::string_view wordAt(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && isWordCharacter(text[end])) ++end;
  return text.substr(at, end - at);
}

bool startsDefinition(std::string_view text, std::size_t at) {
  if (at >= text.size() || text[at] != '(') return false;
  return std::ranges::find(kDefinitionWords, wordAt(text, at + 1)) != kDefinitionWords.end();
}

class Scanning {
public:
  explicit Scanning(std::string_view source) : text(source) {}

  Scan run() {
    while (at < text.size()) {
      char c = text[at];
      if (c == '\n') {
        lineStart = at + 1;
        fresh = true;
        ++at;
      } else if (isSpace(c)) {
        ++at;
      } else if (c == ';') {
        comment();
      } else {
        token(c);
      }
    }
    return std::move(result);
  }

private:
  void comment() {
    std::size_t end = std::min(text.find('\n', at), text.size());
    std::size_t last = end;
    while (last > at && text[last - 1] == '\r') --last;
    result.comments.push_back({offset(at), offset(last)});
    at = end;
  }

  void token(char c) {
    auto word = c == ':' ? text.substr(at, 1 + wordAt(text, at + 1).size()) : std::string_view{};
    if (fresh || c == ':') landmark(word);
    fresh = false;
    if (c == '(' || c == ')') {
      result.parentheses.push_back({offset(at), offset(at - lineStart), c == '('});
      ++at;
    } else if (c == '"') {
      string();
    } else {
      at = std::max(at + 1, at + word.size());
    }
    result.end = offset(at);
  }

  void landmark(std::string_view word) {
    result.landmarks.push_back(
        {.at = offset(at),
         .column = offset(at - lineStart),
         .previousEnd = result.end,
         .parentheses = static_cast<std::uint32_t>(result.parentheses.size()),
         .startsLine = fresh,
         .keyword = !word.empty(),
         .fieldOfDefinition = std::ranges::find(kFields, word) != kFields.end()});
  }

  /// Skips to the closing quote, or to the end of the line.
  void string() {
    std::size_t begin = at;
    for (++at; at < text.size() && !isLineEnd(at); ++at) {
      if (text[at] == '"') {
        ++at;
        return;
      }
      if (text[at] == '\\' && at + 1 < text.size() && !isLineEnd(at + 1)) ++at;
    }
    result.unterminated.push_back({offset(begin), offset(at)});
  }

  [[nodiscard]] bool isLineEnd(std::size_t place) const {
    return text[place] == '\n' || text[place] == '\r';
  }

  static Offset offset(std::size_t at) { return static_cast<Offset>(at); }

  std::string_view text;
  std::size_t at = 0;
  std::size_t lineStart = 0;
  bool fresh = true; ///< only white space so far in this line
  Scan result;
};

} // namespace

std::vector<Range> cut(std::string_view text) {
  if (text.size() > kLongestRead) return {{0, static_cast<Offset>(text.size())}};
  std::vector<Range> regions;
  std::size_t begin = 0;
  for (std::size_t line = 0; line < text.size();) {
    if (line > begin && startsDefinition(text, line)) {
      regions.push_back({static_cast<Offset>(begin), static_cast<Offset>(line)});
      begin = line;
    }
    line = text.find('\n', line);
    if (line != std::string_view::npos) ++line;
  }
  if (begin < text.size())
    regions.push_back({static_cast<Offset>(begin), static_cast<Offset>(text.size())});
  return regions;
}

std::optional<std::string_view> commentLine(std::string_view line) {
  const auto start = line.find_first_not_of(" \t");
  if (start == std::string_view::npos || line[start] != ';') return std::nullopt;
  auto content = line.substr(std::min(line.find_first_not_of(';', start), line.size()));
  if (content.starts_with(' ')) content.remove_prefix(1);
  while (!content.empty() && std::string_view(" \t\r").contains(content.back()))
    content.remove_suffix(1);
  return content;
}

Scan scan(std::string_view text) { return Scanning(text).run(); }

} // namespace proskill::syntax
