#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The layout of models in Fiacre: that of the printer, with the user's comments where they are,
/// and with some choices left to the user: empty lines, a short `if … end` on one line, and whether
/// a branch begins beside its `[]`, `then` or `->`.
namespace proskill::fiacre {

/// Text to put in the place of bytes.
struct Change {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::string text;
  friend bool operator==(const Change&, const Change&) = default;
};

/// The text laid out: white space between its words, signs and comments changes, and nothing else.
/// Laid out again it stays as it is. Nothing where the text cannot be read without a problem.
[[nodiscard]] std::optional<std::string> format(std::string_view text);

/// The same as changes of white space, as few as there are, in the order of the text.
[[nodiscard]] std::optional<std::vector<Change>> formatChanges(std::string_view text);

} // namespace proskill::fiacre
