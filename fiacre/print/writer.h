#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace proskill::fiacre {

/// Prints text in lines under 100 columns. Longer text is broken after commas and connectives, and
/// continues below the innermost open parenthesis.
class Writer {
public:
  static constexpr std::size_t kWidth = 100;
  static constexpr std::size_t kStep = 4; ///< columns per level

  /// Prints a line at `indent` columns, with the comment at its end, or above it if there is no
  /// room. Continuation lines are indented by `hang` more columns.
  void line(std::size_t indent, std::string_view text, std::string_view comment = {},
            std::size_t hang = kStep);
  /// Prints lines of comment; line ends in the text are kept.
  void comment(std::size_t indent, std::string_view text);
  /// Prints an empty line unless the previous line is empty.
  void blank();

  [[nodiscard]] std::uint32_t lines() const { return count; }
  [[nodiscard]] std::string take() { return std::move(text); }

private:
  void put(std::size_t indent, std::string_view line);

  std::string text;
  std::uint32_t count = 0;
};

} // namespace proskill::fiacre
