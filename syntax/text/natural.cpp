#include "syntax/text/natural.h"

#include "syntax/text/characters.h"

#include <algorithm>
#include <utility>

namespace proskill::syntax {

namespace {

/// Removes the number at the beginning of a text; empty if there is none.
std::string_view takeNumber(std::string_view& text) {
  const auto size =
      static_cast<std::size_t>(std::ranges::find_if_not(text, isDigit) - text.begin());
  auto number = text.substr(0, size);
  text.remove_prefix(size);
  return number.substr(std::min(number.find_first_not_of('0'), number.size()));
}

} // namespace

bool isNaturallyBefore(std::string_view a, std::string_view b) {
  auto [left, right] = std::pair(a, b);
  while (!left.empty() && !right.empty()) {
    if (isDigit(left.front()) && isDigit(right.front())) {
      const auto first = takeNumber(left);
      const auto second = takeNumber(right);
      if (first.size() != second.size()) return first.size() < second.size();
      if (first != second) return first < second;
    } else if (left.front() != right.front()) {
      return left.front() < right.front();
    } else {
      left.remove_prefix(1);
      right.remove_prefix(1);
    }
  }
  if (left.empty() != right.empty()) return left.empty();
  return a < b;
}

} // namespace proskill::syntax
