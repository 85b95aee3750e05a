#pragma once

#include <string>
#include <string_view>

namespace proskill::syntax {

/// A text as a message quotes it: the first line, and not all of a long one.
[[nodiscard]] std::string shortened(std::string_view text);

/// A word between backquotes, as messages quote what stands in a program.
[[nodiscard]] inline std::string backquoted(std::string_view word) {
  return "`" + std::string(word) + "`";
}

/// A message with all that it quotes between backquotes shortened.
[[nodiscard]] std::string withShortQuotes(std::string_view message);

} // namespace proskill::syntax
