#include "report/text/text_width.h"

#include "syntax/text/utf8.h"

#include <algorithm>
#include <clocale>
#include <cwchar>
#include <sys/ioctl.h>
#include <unistd.h>

namespace proskill::report {

namespace {

constexpr std::size_t kTabStop = 4;

/// The width of characters as the C library knows it, whatever the locale of the process.
class Utf8Locale {
public:
  Utf8Locale() : locale(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {}
  ~Utf8Locale() {
    if (locale) freelocale(locale);
  }
  Utf8Locale(const Utf8Locale&) = delete;
  Utf8Locale& operator=(const Utf8Locale&) = delete;

  /// Negative for what is not printed.
  [[nodiscard]] int width(char32_t character) const {
    if (character >= 0x20 && character < 0x7F) return 1;
    const locale_t before = locale ? uselocale(locale) : nullptr;
    const int columns = wcwidth(static_cast<wchar_t>(character));
    if (before) uselocale(before);
    return columns;
  }

private:
  locale_t locale;
};

} // namespace

DisplayedLine::DisplayedLine(std::string_view line) {
  static const Utf8Locale locale; // slow to make
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
    } else if (const int width = character ? locale.width(*character) : -1; width >= 0) {
      shown.append(line.substr(0, length));
      column += static_cast<std::size_t>(width);
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
