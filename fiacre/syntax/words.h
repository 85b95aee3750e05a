#pragma once

#include <array>
#include <span>
#include <string_view>

namespace proskill::fiacre {

/// What a declaration begins with.
inline constexpr auto kDeclarations = std::to_array<std::string_view>(
    {"const", "type", "channel", "event", "task", "extern", "function", "process", "component",
     "property", "assert", "prove"});

[[nodiscard]] inline bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Whether a name means something to Fiacre or to H-Fiacre, so that nothing can be called so.
[[nodiscard]] bool isKeyword(std::string_view name);

/// The same, or to their patterns of properties: nothing should be called so that others read.
[[nodiscard]] bool isReserved(std::string_view name);

/// `event`, `task`, `extern`, `start`: words of H-Fiacre that older texts have as names.
[[nodiscard]] bool isSoftName(std::string_view name);

/// All of them, sorted within their groups.
[[nodiscard]] std::span<const std::string_view> reservedWords();

/// Letters, digits and `_`, no digit first.
[[nodiscard]] bool isIdentifier(std::string_view name);

} // namespace proskill::fiacre
