#include "bridge/text/token_reader.h"

#include "syntax/text/quote.h"

#include <fmt/format.h>

namespace proskill::bridge {

bool TokenReader::isAt(std::string_view text) const {
  const auto kind = peek().kind;
  return (kind == TokenKind::Word || kind == TokenKind::Symbol) && peek().text == text;
}

bool TokenReader::takeIf(std::string_view text) {
  const bool fits = isAt(text);
  if (fits) ++at;
  return fits;
}

void TokenReader::expect(std::string_view text) {
  if (!takeIf(text)) fail(syntax::backquoted(text));
}

Word TokenReader::take(TokenKind kind, std::string_view what) {
  Word word{peek().text, peek().place};
  if (peek().kind == kind)
    ++at;
  else
    fail(what);
  return word;
}

void TokenReader::skip() {
  if (isAtEnd()) return fail("more text");
  ++at;
}

void TokenReader::fail(std::string_view needed) {
  const auto found =
      isAtEnd() ? "the end of the file" : syntax::backquoted(syntax::shortened(peek().text));
  fail(peek().place, fmt::format("expected {}, found {}", needed, found));
}

void TokenReader::fail(const Place& place, std::string message) {
  if (!error) error = Error{place, std::move(message)};
  at = tokens.size() - 1;
}

} // namespace proskill::bridge
