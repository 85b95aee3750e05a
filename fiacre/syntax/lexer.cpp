#include "fiacre/syntax/lexer.h"

#include "fiacre/syntax/words.h"

#include <algorithm>
#include <array>

namespace proskill::fiacre {
namespace {

/// Longer symbols come before their prefixes.
constexpr auto kSymbols = std::to_array<std::string_view>(
    {"...", "..", ":=", "->", "<>", "<=", ">=", "=>", "||", "{|", "|}", "<",
     ">",   "=",  "+",  "-",  "*",  "/",  "%",  "(",  ")",  "[",  "]",  "{",
     "}",   ",",  ";",  ":",  "|",  "&",  "!",  "?",  "#",  ".",  "$"});

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool isWord(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || isDigit(c);
}

class Lexer {
public:
  Lexer(std::string_view read, std::vector<SyntaxProblem>& found, bool keep)
      : text(read), problems(found), keepComments(keep) {}

  std::vector<Token> run() {
    if (text.starts_with(kByteOrderMark)) at = kByteOrderMark.size();
    while (skipBlank()) next();
    tokens.push_back({TokenKind::End, text.substr(text.size()), offset(text.size())});
    return std::move(tokens);
  }

private:
  static std::uint32_t offset(std::size_t at) { return static_cast<std::uint32_t>(at); }

  /// Skips white space and comments. \return whether a token follows
  bool skipBlank() {
    for (;;) {
      while (at < text.size() && isSpace(text[at])) ++at;
      const auto begin = at;
      if (text.substr(at, 2) == "//")
        at = std::min(text.find('\n', at), text.size());
      else if (text.substr(at, 2) == "/*")
        skipLongComment();
      else
        return at < text.size();
      if (keepComments) keepComment(begin);
    }
  }

  void keepComment(std::size_t begin) {
    auto comment = text.substr(begin, at - begin);
    while (isSpace(comment.back())) comment.remove_suffix(1);
    tokens.push_back({TokenKind::Comment, comment, offset(begin)});
  }

  void skipLongComment() {
    const auto close = text.find("*/", at + 2);
    if (close == std::string_view::npos)
      problems.push_back({"the comment has no end: `*/` is missing", offset(at), offset(at + 2)});
    at = close == std::string_view::npos ? text.size() : close + 2;
  }

  void next() {
    const char c = text[at];
    if (isDigit(c)) return take(TokenKind::Number, runOf(isDigit));
    if (isWord(c)) return take(TokenKind::Name, runOf(isWord));
    if (c == '"') return takeString();
    const auto symbol = std::ranges::find_if(
        kSymbols, [&](std::string_view each) { return text.substr(at).starts_with(each); });
    if (symbol != kSymbols.end()) return take(TokenKind::Symbol, symbol->size());
    skipUnknown();
  }

  template <class Is> [[nodiscard]] std::size_t runOf(Is is) const {
    auto end = at;
    while (end < text.size() && is(text[end])) ++end;
    return end - at;
  }

  void take(TokenKind kind, std::size_t length) {
    tokens.push_back({kind, text.substr(at, length), offset(at)});
    at += length;
  }

  void takeString() {
    const auto close = text.find_first_of("\"\n", at + 1);
    if (close == std::string_view::npos || text[close] == '\n') {
      problems.push_back({"the string has no end: `\"` is missing", offset(at), offset(at + 1)});
      return take(TokenKind::String, std::min(close, text.size()) - at);
    }
    take(TokenKind::String, close + 1 - at);
  }

  static bool isUnknown(char c) {
    return !isSpace(c) && !isWord(c) && c != '"' &&
           std::ranges::none_of(kSymbols, [c](auto symbol) { return symbol.front() == c; });
  }

  void skipUnknown() {
    const auto length = runOf(isUnknown);
    problems.push_back({"unexpected character", offset(at), offset(at + length)});
    at += length;
  }

  std::string_view text;
  std::vector<SyntaxProblem>& problems;
  std::vector<Token> tokens;
  std::size_t at = 0;
  bool keepComments;
};

} // namespace

bool beginsDeclaration(const Token& token, const Token& next, const Token& second) {
  if (token.kind != TokenKind::Name) return false;
  if (std::ranges::find(kDeclarations, token.text) == kDeclarations.end()) return false;
  return isKeyword(token.text) ||
         (next.kind == TokenKind::Name && (second.text == ":" || second.text == "("));
}

std::vector<Token> tokenize(std::string_view text, std::vector<SyntaxProblem>& problems) {
  return Lexer(text, problems, false).run();
}

std::vector<Token> tokenizeWithComments(std::string_view text) {
  std::vector<SyntaxProblem> problems;
  return Lexer(text, problems, true).run();
}

} // namespace proskill::fiacre
