#pragma once

#include "syntax/document.h"

#include <string_view>
#include <vector>

/// The position of a cursor, computed from the text before it. Missing parentheses after it and
/// syntax errors make no difference while typing.
namespace proskill::ide {

/// A direct element of a list: a word or a nested list.
struct Item {
  syntax::Range range;
  std::string_view text; ///< empty: a list
  bool startsLine = false;

  [[nodiscard]] bool isList() const { return text.empty(); }
  [[nodiscard]] bool isKeyword() const { return text.starts_with(':'); }
  [[nodiscard]] bool isParameter() const { return text.starts_with('$'); }
};

/// A list that is open at the cursor.
struct OpenList {
  syntax::Offset begin = 0; ///< of its parenthesis
  std::vector<Item> items;  ///< elements that end before the cursor's word
};

enum class Surrounding : std::uint8_t { Code, String, Comment };

struct Path {
  std::vector<OpenList> lists; ///< outermost first
  /// The word that contains or touches the cursor; empty if there is none. In a string, the text
  /// between the quotes.
  syntax::Range word;
  std::string_view prefix; ///< the word up to the cursor
  Surrounding surrounding = Surrounding::Code;
  bool isInInterval = false; ///< the word is a bound of an interval
};

/// \pre `at` is at most the text's length
[[nodiscard]] Path pathTo(const syntax::Document& document, syntax::Offset at);

/// The last form that begins before a place; null if there is none.
[[nodiscard]] const syntax::Form* formBefore(const syntax::Document& document, syntax::Offset at);

} // namespace proskill::ide
