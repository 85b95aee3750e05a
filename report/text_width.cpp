#include "report/text_width.h"

#include <algorithm>
#include <clocale>
#include <cwchar>
#include <optional>
#include <sys/ioctl.h>
#include <unistd.h>

namespace proskill::cli {

namespace {

constexpr std::size_t kTabStop = 4;
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

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

bool isContinuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

std::size_t expectedLength(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

/// The character at the start of a text, where it is well-formed.
std::optional<char32_t> decode(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t length = expectedLength(first);
  if (length == 0 || length > text.size()) return std::nullopt;
  if (length == 1) return first;
  char32_t value = first & (0x7Fu >> length);
  for (char byte : text.substr(1, length - 1)) {
    if (!isContinuation(byte)) return std::nullopt;
    value = (value << 6) | (static_cast<unsigned char>(byte) & 0x3Fu);
  }
  const bool tooLong = (length == 3 && value < 0x800) || (length == 4 && value < 0x10000);
  const bool surrogate = value >= 0xD800 && value < 0xE000;
  if (tooLong || surrogate || value > 0x10FFFF) return std::nullopt;
  return value;
}

} // namespace

std::size_t characterLength(std::string_view text) {
  return decode(text) ? expectedLength(static_cast<unsigned char>(text[0])) : 1;
}

DisplayedLine::DisplayedLine(std::string_view line) {
  static const Utf8Locale locale; // slow to make
  std::size_t column = 0;
  columns.reserve(line.size() + 1);
  while (!line.empty()) {
    const std::size_t length = characterLength(line);
    const auto character = decode(line);
    columns.insert(columns.end(), length, column);
    if (line[0] == '\t') {
      const std::size_t spaces = kTabStop - column % kTabStop;
      shown.append(spaces, ' ');
      column += spaces;
    } else if (const int width = character ? locale.width(*character) : -1; width >= 0) {
      shown.append(line.substr(0, length));
      column += static_cast<std::size_t>(width);
    } else {
      shown.append(kReplacement);
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

} // namespace proskill::cli
