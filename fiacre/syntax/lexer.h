#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::fiacre {

/// A syntax error and its place in bytes.
struct SyntaxProblem {
  std::string message; ///< "`then` is missing"
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

enum class TokenKind : std::uint8_t { Name, Number, String, Symbol, Comment, End };

/// A token of a text; the text must outlive it.
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

/// Whether a declaration begins here. `event`, `task` and `extern` may be names in older texts; in
/// declarations a name and its type or parameters follow.
[[nodiscard]] bool beginsDeclaration(const Token& token, const Token& next, const Token& second);

/// The tokens of a text without comments; the last is an End token. Bytes that do not belong to
/// Fiacre are skipped, with one problem for each sequence of them.
[[nodiscard]] std::vector<Token> tokenize(std::string_view text,
                                          std::vector<SyntaxProblem>& problems);

/// The same with comments, without the white space at the end of line comments.
[[nodiscard]] std::vector<Token> tokenizeWithComments(std::string_view text);

} // namespace proskill::fiacre
