#pragma once

#include "bridge/text/lexer.h"

#include <optional>

namespace proskill::bridge {

/// Goes through tokens. After the first token that does not fit, only the end is left.
class TokenReader {
public:
  explicit TokenReader(std::vector<Token> all) : tokens(std::move(all)) {}

  [[nodiscard]] const Token& peek() const { return tokens[at]; }
  [[nodiscard]] bool isAt(std::string_view text) const;
  [[nodiscard]] bool isAtEnd() const { return peek().kind == TokenKind::End; }
  [[nodiscard]] const std::optional<Error>& firstError() const { return error; }

  bool takeIf(std::string_view text);
  void expect(std::string_view text);
  /// The next token, which must be a word, a number or a string. \param what it is, for messages
  Word take(TokenKind kind, std::string_view what);
  Word word(std::string_view what) { return take(TokenKind::Word, what); }
  /// Skips a token, or ends with an error if there is none.
  void skip();
  /// Reports what was expected instead of the next token.
  void fail(std::string_view needed);
  void fail(const Place& place, std::string message);

  /// Calls `read` once, or for each item of a list in braces.
  template <class Read> void oneOrMore(Read&& read) {
    if (takeIf("{"))
      untilBrace(read);
    else
      read();
  }
  /// Calls `read` until a closing brace.
  template <class Read> void untilBrace(Read&& read) {
    while (!isAtEnd() && !isAt("}")) read();
    expect("}");
  }

private:
  std::vector<Token> tokens;
  std::size_t at = 0;
  std::optional<Error> error;
};

} // namespace proskill::bridge
