#include "report/text/text_width.h"

#include "syntax/text/utf8.h"

#include <algorithm>
#include <optional>
#include <sys/ioctl.h>
#include <unistd.h>

namespace proskill::report {

namespace {

constexpr std::size_t kTabStop = 4;

} // namespace

DisplayedLine::DisplayedLine(std::string_view line) {
  std::size_t column = 0;
  columns.reserve(line.size() + 1);
  while (!line.empty()) {
    const std::size_t length = syntax::characterLength(line);
    const auto character = syntax::firstCharacter(line);
    columns.insert(columns.end(), length, column);
    if (line[0] == '\t') {
      const std::size_t spaces = kTabStop - column % kTabStop;
      shown.append(spaces, ' ');
      column += spaces;
    } else if (const auto width = character ? syntax::columnsOf(*character) : std::nullopt) {
      shown.append(line.substr(0, length));
      column += *width;
    } else {
      shown.append(syntax::kReplacement);
      ++column;
    }
    line.remove_prefix(length);
  }
  columns.push_back(column);
}

std::size_t DisplayedLine::column(std::size_t byte) const {
  return columns[std::min(byte, columns.size() - 1)];
}

std::size_t terminalWidth(int fileDescriptor, std::size_t otherwise) {
  winsize size{};
  if (ioctl(fileDescriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return otherwise;
  return size.ws_col;
}

} // namespace proskill::report
