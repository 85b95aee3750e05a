#pragma once

#include <span>
#include <string_view>

namespace proskill::fiacre {

/// Whether a name means something to Fiacre, to H-Fiacre, or to their patterns of properties, so
/// that nothing may be called so.
[[nodiscard]] bool isReserved(std::string_view name);

/// All of them, sorted within their groups.
[[nodiscard]] std::span<const std::string_view> reservedWords();

/// Letters, digits and `_`, no digit first.
[[nodiscard]] bool isIdentifier(std::string_view name);

} // namespace proskill::fiacre
