#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace proskill::fiacre {

/// Lays text out in lines under 100 columns: breaks what is longer behind commas and connectives,
/// and goes on below the innermost open parenthesis.
class Writer {
public:
  static constexpr std::size_t kWidth = 100;
  static constexpr std::size_t kStep = 4; ///< columns of one level

  /// A line at `indent` columns, the comment at its end, or above where there is no room for it.
  /// What does not fit goes on `hang` columns further in.
  void line(std::size_t indent, std::string_view text, std::string_view comment = {},
            std::size_t hang = kStep);
  /// Lines of comment; the text's own line ends are kept.
  void comment(std::size_t indent, std::string_view text);
  /// An empty line, unless one is there already.
  void blank();

  [[nodiscard]] std::uint32_t lines() const { return count; }
  [[nodiscard]] std::string take() { return std::move(text); }

private:
  void put(std::size_t indent, std::string_view line);

  std::string text;
  std::uint32_t count = 0;
};

} // namespace proskill::fiacre
