#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::fiacre {

/// What is wrong with a text, and where: bytes.
struct SyntaxProblem {
  std::string message; ///< "`then` is missing"
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

enum class TokenKind : std::uint8_t { Name, Number, String, Symbol, Comment, End };

/// A word or sign of a text, which outlives it.
struct Token {
  TokenKind kind = TokenKind::End;
  std::string_view text;
  std::uint32_t begin = 0;

  [[nodiscard]] std::uint32_t end() const {
    return begin + static_cast<std::uint32_t>(text.size());
  }
};

[[nodiscard]] inline bool isComment(const Token& token) { return token.kind == TokenKind::Comment; }

inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Whether a declaration begins here. `event`, `task` and `extern` are names in older texts: as
/// declarations they have a name and its type or parameters behind them.
[[nodiscard]] bool beginsDeclaration(const Token& token, const Token& next, const Token& second);

/// The words and signs of a text, without its comments; an End token is last. Bytes that are none
/// of Fiacre are problems, one for each run of them, and left out.
[[nodiscard]] std::vector<Token> tokenize(std::string_view text,
                                          std::vector<SyntaxProblem>& problems);

/// The same with its comments, those of a line without the white space at its end; an End token is
/// last.
[[nodiscard]] std::vector<Token> tokenizeWithComments(std::string_view text);

} // namespace proskill::fiacre
