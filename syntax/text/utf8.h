#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Decoding of UTF-8 (The Unicode Standard, section 3.9). Nothing else decodes it.
namespace proskill::syntax {

/// U+FFFD, the replacement for bytes that are not UTF-8 and for characters that cannot be shown.
inline constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// A text without the mark that editors on Windows write before its first character.
[[nodiscard]] constexpr std::string_view withoutByteOrderMark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

/// Whether a byte continues a character.
[[nodiscard]] constexpr bool continuesCharacter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// The length of the well-formed sequence at the start of a text, by table 3-7; 0 if there is none.
[[nodiscard]] std::size_t sequenceLength(std::string_view text);

/// The length of a text's first character, in bytes; 1 for a byte that begins no character.
/// \pre `text` is not empty
[[nodiscard]] inline std::size_t characterLength(std::string_view text) {
  return std::max<std::size_t>(sequenceLength(text), 1);
}

/// The character at the start of a text; nothing if the bytes are not UTF-8.
[[nodiscard]] std::optional<char32_t> firstCharacter(std::string_view text);

/// The number of terminal columns of a character; nothing if terminals do not show it.
[[nodiscard]] std::optional<std::size_t> columnsOf(char32_t character);

/// The number of characters of a text; continuation bytes are not counted.
[[nodiscard]] constexpr std::size_t countCharacters(std::string_view text) {
  return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, continuesCharacter));
}

/// The last character boundary at or before an offset.
[[nodiscard]] constexpr std::size_t characterStart(std::string_view text, std::size_t at) {
  while (at > 0 && at < text.size() && continuesCharacter(text[at])) --at;
  return at;
}

/// Calls `write(character, bytes)` for each character of a text, with U+FFFD for each byte that is
/// not UTF-8.
template <class Write> void forEachCharacter(std::string_view text, Write write) {
  while (!text.empty()) {
    const auto character = firstCharacter(text);
    const auto length = characterLength(text);
    write(character.value_or(U'\uFFFD'), character ? text.substr(0, length) : kReplacement);
    text.remove_prefix(length);
  }
}

/// A text that is safe to print: control characters (C0, C1, DEL) and bytes that are not UTF-8
/// become U+FFFD, except the characters in `kept`. It neither controls the terminal nor breaks the
/// line.
[[nodiscard]] inline std::string printable(std::string_view text, std::string_view kept = "") {
  std::string out;
  forEachCharacter(text, [&](char32_t character, std::string_view bytes) {
    const bool controls = character < 0x20 || (character >= 0x7F && character < 0xA0);
    out += controls && !kept.contains(bytes) ? kReplacement : bytes;
  });
  return out;
}

} // namespace proskill::syntax
