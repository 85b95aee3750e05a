#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::report {

/// A line of a program as a terminal displays it: tabs become spaces; control characters and
/// invalid UTF-8 become `�`.
class DisplayedLine {
public:
  explicit DisplayedLine(std::string_view line);

  [[nodiscard]] const std::string& text() const { return shown; }
  /// The column, from 0, at which a byte is displayed; after the end: the column of the end.
  [[nodiscard]] std::size_t column(std::size_t byte) const;

private:
  std::string shown;
  std::vector<std::size_t> columns; ///< by byte, and of the end
};

/// The width of the terminal at a file descriptor in columns; `otherwise` if it is not a terminal.
[[nodiscard]] std::size_t terminalWidth(int fileDescriptor, std::size_t otherwise);

} // namespace proskill::report
