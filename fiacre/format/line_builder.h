#pragma once

#include "fiacre/format/format_lines.h"

#include <algorithm>
#include <array>
#include <optional>

namespace proskill::fiacre {

template <std::size_t N>
bool isAmong(std::string_view text, const std::array<std::string_view, N>& texts) {
  return std::ranges::find(texts, text) != texts.end();
}

/// Distributes the tokens of a model to lines, with comments in their places. The derived class
/// decides what begins a line.
class LineBuilder {
protected:
  LineBuilder(std::string_view read, const std::vector<Token>& tokens);
  ~LineBuilder() = default;

  // A following token; comments are skipped.
  [[nodiscard]] const Token& peek(std::size_t ahead = 0) const {
    return all[words[std::min(at + ahead, words.size() - 1)]];
  }
  [[nodiscard]] bool isAt(std::string_view wanted, std::size_t ahead = 0) const {
    const Token& token = peek(ahead);
    return token.text == wanted && token.kind != TokenKind::String;
  }
  [[nodiscard]] const Token* previous() const { return at == 0 ? nullptr : &all[words[at - 1]]; }
  [[nodiscard]] bool commentsBefore() const {
    return words[at] > 0 && isComment(all[words[at] - 1]);
  }
  /// Whether the next token is on the same line as the previous one in the user's text.
  [[nodiscard]] bool besidePrevious() const {
    return previous() && !commentsBefore() && !isLineBreak(text, *previous(), peek());
  }

  /// Begins a line, after the comments before it.
  void start(std::size_t indent, std::string_view lead = {}, std::size_t leadWidth = 0);
  /// Takes a token, or a whole time interval.
  void take();
  /// Takes the comments before the next token. Comments at the end of the last line stay there;
  /// others get their own lines. If the line continues, they become part of it.
  void takeComments();
  /// Puts an empty line before the current line, or before the comments directly above it.
  void separate();

  /// The indentation of a comment on its own line.
  [[nodiscard]] virtual std::size_t commentIndent(std::size_t comment) = 0;
  [[nodiscard]] bool blankBefore(std::size_t index) const { return newlinesBefore(index) > 1; }
  /// The column of a token; imprecise in lines that are longer than any handwritten one.
  [[nodiscard]] std::size_t column(const Token& token) const;
  /// The last of the adjacent comments that start with this one. Call it in order, so that each
  /// comment is visited once.
  [[nodiscard]] std::size_t lastTouching(std::size_t comment);

  std::string_view text;
  const std::vector<Token>& all;
  std::vector<std::size_t> words; ///< indices into `all`
  std::size_t at = 0;             ///< index into `words`
  std::vector<FormatLine> lines;
  bool ended = true;     ///< the next token begins a line
  std::size_t depth = 0; ///< nesting of brackets

private:
  void takeOne();
  void noteDepth(const Token& token);
  [[nodiscard]] bool isBeforeInterval() const;
  [[nodiscard]] std::size_t newlinesBefore(std::size_t index) const;

  std::size_t taken = 0;               ///< comments before this one have been placed
  std::optional<std::size_t> touching; ///< the end of the current group of adjacent comments
};

} // namespace proskill::fiacre
