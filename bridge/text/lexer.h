#pragma once

#include "bridge/text/word.h"

#include <expected>
#include <string_view>

namespace proskill::bridge {

/// A directive is a line that begins with `#`.
enum class TokenKind : std::uint8_t { Word, Number, String, Symbol, Directive, End };

struct Token {
  TokenKind kind = TokenKind::End;
  std::string text; ///< of a string: without quotes; escapes stay as they are
  Place place;
};

/// Cuts a text into tokens; the last one is `End`. Comments are `// …` and `/* … */`.
/// \return the tokens, or the first character that begins none
[[nodiscard]] std::expected<std::vector<Token>, Error> tokensOf(std::string_view text,
                                                                const std::filesystem::path& file);

} // namespace proskill::bridge
