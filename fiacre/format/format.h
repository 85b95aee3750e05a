#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Formatting of Fiacre models: the layout of the printer, with comments in their places. The user
/// decides about empty lines, whether a short `if … end` is on one line, and whether a branch
/// begins next to its `[]`, `then` or `->`.
namespace proskill::fiacre {

/// Replaces bytes by a text.
struct Change {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::string text;
  friend bool operator==(const Change&, const Change&) = default;
};

/// Formats a text. Changes only white space, and is idempotent. Nothing if the text has syntax
/// errors.
[[nodiscard]] std::optional<std::string> format(std::string_view text);

/// The same as minimal changes of white space, in the order of the text.
[[nodiscard]] std::optional<std::vector<Change>> formatChanges(std::string_view text);

} // namespace proskill::fiacre
