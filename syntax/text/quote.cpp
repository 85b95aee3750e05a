#include "syntax/text/quote.h"

#include <algorithm>

namespace proskill::syntax {

namespace {

/// Bytes: of what is longer so many are shown, and no half letter.
constexpr std::size_t kLongest = 60;

bool isWithinLetter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

} // namespace

std::string shortened(std::string_view text) {
  auto end = std::min({text.size(), text.find_first_of("\r\n"), kLongest});
  while (end > 0 && end < text.size() && isWithinLetter(text[end])) --end;
  const std::string shown(text.substr(0, end));
  return end == text.size() ? shown : shown + "...";
}

std::string withShortQuotes(std::string_view message) {
  std::string result;
  bool isQuoted = false;
  while (true) {
    const auto end = message.find('`');
    const auto part = message.substr(0, end);
    result += isQuoted ? shortened(part) : part;
    if (end == std::string_view::npos) return result;
    result += '`';
    message.remove_prefix(end + 1);
    isQuoted = !isQuoted;
  }
}

} // namespace proskill::syntax
