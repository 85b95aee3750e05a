#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// UTF-8 (The Unicode Standard, section 3.9): the one place that decodes it.
namespace proskill::syntax {

/// What stands for a byte that is not UTF-8, or for a character that cannot be shown: U+FFFD.
inline constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Whether a byte goes on with a character that an earlier one begins.
[[nodiscard]] constexpr bool continuesCharacter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// The bytes of the well-formed sequence at the start of a text, by table 3-7; 0 where there is
/// none.
[[nodiscard]] std::size_t sequenceLength(std::string_view text);

/// The bytes that a text's first character takes; 1 for a byte that begins none.
/// \pre `text` is not empty.
[[nodiscard]] inline std::size_t characterLength(std::string_view text) {
  return std::max<std::size_t>(sequenceLength(text), 1);
}

/// The character at the start of a text; nothing where the bytes are not UTF-8.
[[nodiscard]] std::optional<char32_t> firstCharacter(std::string_view text);

/// How many columns of a terminal a character takes; nothing where a terminal does not show it.
[[nodiscard]] std::optional<std::size_t> columnsOf(char32_t character);

/// How many characters a text has; the bytes that go on with one are not counted.
[[nodiscard]] constexpr std::size_t countCharacters(std::string_view text) {
  return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, continuesCharacter));
}

/// The last place at or before a byte where no character is cut.
[[nodiscard]] constexpr std::size_t characterStart(std::string_view text, std::size_t at) {
  while (at > 0 && at < text.size() && continuesCharacter(text[at])) --at;
  return at;
}

/// A text character by character: `write(character, its bytes)`, with U+FFFD for each byte that is
/// not UTF-8.
template <class Write> void forEachCharacter(std::string_view text, Write write) {
  while (!text.empty()) {
    const auto character = firstCharacter(text);
    const auto length = characterLength(text);
    write(character.value_or(U'\uFFFD'), character ? text.substr(0, length) : kReplacement);
    text.remove_prefix(length);
  }
}

/// A text that no terminal obeys and that breaks no line: what controls one (C0, C1, DEL) and what
/// is not UTF-8 becomes U+FFFD, but for the characters that are kept.
[[nodiscard]] inline std::string printable(std::string_view text, std::string_view kept = "") {
  std::string out;
  forEachCharacter(text, [&](char32_t character, std::string_view bytes) {
    const bool controls = character < 0x20 || (character >= 0x7F && character < 0xA0);
    out += controls && !kept.contains(bytes) ? kReplacement : bytes;
  });
  return out;
}

} // namespace proskill::syntax
