#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

/// What single characters are to ProSkill's texts, whatever the system's language.
namespace proskill::syntax {

[[nodiscard]] inline bool isSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

[[nodiscard]] inline bool isWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// How many characters a text has; the bytes of UTF-8 that go on with one are not counted.
[[nodiscard]] inline std::uint32_t widthOf(std::string_view text) {
  return static_cast<std::uint32_t>(
      std::ranges::count_if(text, [](char byte) { return (byte & 0xc0) != 0x80; }));
}

} // namespace proskill::syntax
