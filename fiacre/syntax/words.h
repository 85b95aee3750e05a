#pragma once

#include <array>
#include <span>
#include <string_view>

namespace proskill::fiacre {

/// The keywords with which declarations begin.
inline constexpr auto kDeclarations = std::to_array<std::string_view>(
    {"const", "type", "channel", "event", "task", "extern", "function", "process", "component",
     "property", "assert", "prove"});

[[nodiscard]] inline bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Whether a name is a keyword of Fiacre or H-Fiacre, and so cannot be used as a name.
[[nodiscard]] bool isKeyword(std::string_view name);

/// Whether a name is a keyword, or a word of their property patterns: avoid it as a name, because
/// other tools may read it.
[[nodiscard]] bool isReserved(std::string_view name);

/// `event`, `task`, `extern`, `start`: keywords of H-Fiacre that older texts use as names.
[[nodiscard]] bool isSoftName(std::string_view name);

/// All reserved words, in groups, each sorted.
[[nodiscard]] std::span<const std::string_view> reservedWords();

/// Whether it consists of letters, digits and `_` and does not begin with a digit.
[[nodiscard]] bool isIdentifier(std::string_view name);

} // namespace proskill::fiacre
