#include "syntax/text/quote.h"

#include "syntax/text/utf8.h"

#include <algorithm>

namespace proskill::syntax {

namespace {

/// In bytes. Longer text is cut at a character boundary.
constexpr std::size_t kLongest = 60;

} // namespace

std::string shortened(std::string_view text) {
  const auto end = std::min({text.size(), text.find_first_of("\r\n"), kLongest});
  const std::string shown(text.substr(0, characterStart(text, end)));
  return shown.size() == text.size() ? shown : shown + "...";
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
