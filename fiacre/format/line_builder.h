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

/// Reads the tokens of a model one after the other and puts them into lines, comments where they
/// belong. What begins a line is for the class that derives from it to say.
class LineBuilder {
protected:
  LineBuilder(std::string_view read, const std::vector<Token>& tokens);
  ~LineBuilder() = default;

  // Tokens, the comments apart.
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
  /// The user has written the next token on the line of the one before.
  [[nodiscard]] bool besidePrevious() const {
    return previous() && !commentsBefore() && !isLineBreak(text, *previous(), peek());
  }

  /// A line begins here, behind the comments that come before it.
  void start(std::size_t indent, std::string_view lead = {}, std::size_t leadWidth = 0);
  /// Takes a token, an interval of time as a whole.
  void take();
  /// Comments before the next token: those behind the last line's end stay there, the others get
  /// lines. Where the line goes on, they are part of it.
  void takeComments();
  /// An empty line before the line at hand, or before the comments that touch it.
  void separate();

  /// How far in a comment stands that has a line of its own.
  [[nodiscard]] virtual std::size_t commentIndent(std::size_t comment) = 0;
  [[nodiscard]] bool blankBefore(std::size_t index) const { return newlinesBefore(index) > 1; }
  /// Of lines longer than any that people write, where from is all the same.
  [[nodiscard]] std::size_t column(const Token& token) const;
  /// The last of the comments that touch one another from this one on. They are looked at in their
  /// order, so each once.
  [[nodiscard]] std::size_t lastTouching(std::size_t comment);

  std::string_view text;
  const std::vector<Token>& all;
  std::vector<std::size_t> words; ///< places in `all`
  std::size_t at = 0;             ///< in `words`
  std::vector<FormatLine> lines;
  bool ended = true;     ///< the next token begins a line
  std::size_t depth = 0; ///< of brackets

private:
  void takeOne();
  void noteDepth(const Token& token);
  [[nodiscard]] bool isBeforeInterval() const;
  [[nodiscard]] std::size_t newlinesBefore(std::size_t index) const;

  std::size_t taken = 0;               ///< comments before it are in lines
  std::optional<std::size_t> touching; ///< the end of the comments at hand that touch one another
};

} // namespace proskill::fiacre
