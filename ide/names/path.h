#pragma once

#include "syntax/document.h"

#include <string_view>
#include <vector>

/// Where a cursor stands, told from the text before it alone: no parenthesis after it, and nothing
/// that the grammar cannot take, makes a difference to somebody who is typing.
namespace proskill::ide {

/// What stands directly in a list: a word, or a whole list.
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
  std::vector<Item> items;  ///< those that ended before the cursor's word
};

enum class Surrounding : std::uint8_t { Code, String, Comment };

struct Path {
  std::vector<OpenList> lists; ///< outermost first
  /// The word that the cursor stands in or touches; empty where it touches none. Of a string, what
  /// stands between its quotes.
  syntax::Range word;
  std::string_view prefix; ///< the word up to the cursor
  Surrounding surrounding = Surrounding::Code;
};

/// \pre at <= the text's length
[[nodiscard]] Path pathTo(const syntax::Document& document, syntax::Offset at);

/// The form whose text a place belongs to: the last one that begins before it. Null before the
/// first.
[[nodiscard]] const syntax::Form* formBefore(const syntax::Document& document, syntax::Offset at);

} // namespace proskill::ide
