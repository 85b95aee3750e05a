#pragma once

#include "syntax/text/utf8.h"

#include <cstdint>
#include <string_view>

/// Classes of characters in ProSkill texts, independent of the locale.
namespace proskill::syntax {

[[nodiscard]] inline bool isSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

[[nodiscard]] inline bool isDigit(char c) { return c >= '0' && c <= '9'; }

[[nodiscard]] inline bool isWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || isDigit(c) || c == '_';
}

/// The number of columns of a text without wide characters.
[[nodiscard]] inline std::uint32_t widthOf(std::string_view text) {
  return static_cast<std::uint32_t>(countCharacters(text));
}

} // namespace proskill::syntax
