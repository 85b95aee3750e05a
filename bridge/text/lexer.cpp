#include "bridge/text/lexer.h"

#include "syntax/text/quote.h"
#include "syntax/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace proskill::bridge {
namespace {

/// Longer ones first.
constexpr auto kSymbols = std::to_array<std::string_view>(
    {"->", "=>", "==", "!=", "::", "{", "}", "(", ")", ":", ",", "<", ">", ".",
     "/",  "[",  "]",  "|",  "+",  "!", ";", "=", "*", "-", "%", "&", "^", "~"});

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

class Lexer {
public:
  Lexer(std::string_view text, const std::filesystem::path& file) : text(text), place{file, 1, 1} {}

  std::expected<std::vector<Token>, Error> run() {
    std::vector<Token> tokens;
    while (true) {
      if (const auto error = skipSpace()) return std::unexpected(*error);
      auto token = next();
      if (!token) return std::unexpected(token.error());
      tokens.push_back(*std::move(token));
      if (tokens.back().kind == TokenKind::End) return tokens;
    }
  }

private:
  [[nodiscard]] std::string_view rest() const { return text.substr(at); }

  void move(std::size_t count) {
    for (; count > 0; --count, ++at) {
      const bool ends = text[at] == '\n';
      place.line += ends ? 1 : 0;
      place.column = ends ? 1 : place.column + 1;
    }
  }

  std::optional<Error> skipSpace() {
    while (at < text.size()) {
      if (isSpace(text[at])) {
        move(1);
      } else if (rest().starts_with("//")) {
        move(std::min(rest().find('\n'), rest().size()));
      } else if (rest().starts_with("/*")) {
        const auto end = text.find("*/", at + 2);
        if (end == std::string_view::npos) return Error{place, "this comment is never closed"};
        move(end + 2 - at);
      } else {
        break;
      }
    }
    return std::nullopt;
  }

  Token take(TokenKind kind, std::size_t length) {
    Token token{kind, std::string(text.substr(at, length)), place};
    move(length);
    return token;
  }

  template <class Belongs> std::size_t span(Belongs&& belongs) const {
    std::size_t length = 0;
    while (at + length < text.size() && belongs(text[at + length])) ++length;
    return length;
  }

  std::expected<Token, Error> next() {
    if (at == text.size()) return Token{TokenKind::End, "", place};
    const char c = text[at];
    if (isLetter(c))
      return take(TokenKind::Word, span([](char it) { return isLetter(it) || isDigit(it); }));
    if (isDigit(c))
      return take(TokenKind::Number, span([](char it) { return isDigit(it) || it == '.'; }));
    if (c == '"' || c == '\'') return string(c);
    if (c == '#') return take(TokenKind::Directive, std::min(rest().find('\n'), rest().size()));
    for (const auto symbol : kSymbols)
      if (rest().starts_with(symbol)) return take(TokenKind::Symbol, symbol.size());
    return std::unexpected(Error{place, "unexpected character " + syntax::backquoted({&c, 1})});
  }

  std::expected<Token, Error> string(char quote) {
    auto end = at + 1;
    while (end < text.size() && text[end] != quote && text[end] != '\n')
      end += text[end] == '\\' ? 2 : 1;
    if (end >= text.size() || text[end] == '\n')
      return std::unexpected(Error{place, fmt::format("this string has no closing `{}`", quote)});
    auto token = take(TokenKind::String, end + 1 - at);
    token.text = token.text.substr(1, token.text.size() - 2);
    return token;
  }

  std::string_view text;
  std::size_t at = 0;
  Place place;
};

} // namespace

std::expected<std::vector<Token>, Error> tokensOf(std::string_view text,
                                                  const std::filesystem::path& file) {
  return Lexer(syntax::withoutByteOrderMark(text), file).run();
}

} // namespace proskill::bridge
