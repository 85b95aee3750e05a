#pragma once

#include <string>
#include <string_view>

namespace proskill::syntax {

/// A text shortened for a quotation in a message: the first line, up to a maximal length.
[[nodiscard]] std::string shortened(std::string_view text);

/// A word of a program between backquotes, for messages.
[[nodiscard]] inline std::string backquoted(std::string_view word) {
  return "`" + std::string(word) + "`";
}

/// The message with everything between backquotes shortened.
[[nodiscard]] std::string withShortQuotes(std::string_view message);

} // namespace proskill::syntax
