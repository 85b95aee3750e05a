#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::report {

/// A line of a program as a terminal shows it: tabs become spaces, and what would move the cursor
/// or is not UTF-8 becomes `�`.
class DisplayedLine {
public:
  explicit DisplayedLine(std::string_view line);

  [[nodiscard]] const std::string& text() const { return shown; }
  /// The column, from 0, at which the byte is shown; after the end: that of the end.
  [[nodiscard]] std::size_t column(std::size_t byte) const;

private:
  std::string shown;
  std::vector<std::size_t> columns; ///< of each byte, and of the end
};

/// The columns of the terminal at a file descriptor; `otherwise` where it is none.
[[nodiscard]] std::size_t terminalWidth(int fileDescriptor, std::size_t otherwise);

} // namespace proskill::report
