#pragma once

#include "syntax/format/format_boxes.h"

#include <functional>

namespace proskill::syntax {

/// The white space before a token: line ends, then spaces.
struct Gap {
  Range old;
  std::uint32_t lines = 0;
  std::uint32_t spaces = 0;
};

/// Places boxes in sequence and records the white space between their tokens.
class Layout {
public:
  explicit Layout(std::string_view text) : text(text) {}

  /// Formats the top level of a region.
  void region(const Boxes& boxes);
  /// Skips a region that stays as it is.
  void leave(Range region);
  /// Call this after the last region: sets the space at the end of the text, and aligns comments.
  void finish();

  std::vector<Gap> gaps;

private:
  /// The separation between a token and the one before it. After a comment it is always a new line.
  struct Separator {
    enum class Kind : std::uint8_t { None, Space, Line } kind = Kind::None;
    std::uint32_t indent = 0; ///< of the new line, if there is one
  };
  static Separator none(std::uint32_t indent) { return {Separator::Kind::None, indent}; }
  static Separator space(std::uint32_t indent) { return {Separator::Kind::Space, indent}; }
  static Separator line(std::uint32_t indent) { return {Separator::Kind::Line, indent}; }

  /// A comment after a token on the same line.
  struct Trailing {
    std::size_t gap = 0;
    std::uint32_t row = 0;
    std::uint32_t column = 0;       ///< where the token before it ends
    std::uint32_t sourceColumn = 0; ///< of the comment, as its author wrote it
  };

  using Index = std::size_t;

  // \param after number of characters that must follow on the same line: closing parentheses
  void box(Index at, Separator before, std::uint32_t after, std::uint32_t hang = 0);
  void broken(Index at, Separator before, std::uint32_t after, std::uint32_t hang);
  void flat(Index at, Separator before);
  void definition(Index at, Separator before, std::uint32_t after);
  void property(Index at, Separator before, std::uint32_t after);
  void body(Index at, Separator before, std::uint32_t after);
  void timeout(Index at, Separator before, std::uint32_t after);
  void field(Index at, Separator before, std::uint32_t after);
  void tagged(Index at, Separator before, std::uint32_t after, std::uint32_t hang);
  void hanging(Index at, Separator before, std::uint32_t after);
  void control(Index at, Separator before, std::uint32_t after);
  void list(Index at, Separator before, std::uint32_t after);
  void lines(Index at, Separator before, std::uint32_t after);
  void headed(Index at, Separator before, std::uint32_t after, bool filled);
  void form(Index at, Separator before, std::uint32_t indent,
            const std::function<void(Index child, bool first)>& place);

  // format_gaps.cpp: the white space before a token
  void comment(Index at, std::uint32_t indent);
  void token(Range range, Separator before);
  void close(Index at, std::uint32_t indent);
  [[nodiscard]] std::uint32_t columnOf(Separator before) const;
  [[nodiscard]] std::uint32_t linesBefore(Offset token) const;
  void alignTrailing();
  [[nodiscard]] std::uint32_t columnIn(Offset at) const;

  [[nodiscard]] bool fits(Index at, Separator before, std::uint32_t after) const;
  [[nodiscard]] Index endOf(Index at) const { return at + (*boxes)[at].size; }
  [[nodiscard]] Index nextOf(Index child) const { return child + (*boxes)[child].size; }
  [[nodiscard]] std::uint32_t afterChild(Index parent, Index child, std::uint32_t after) const;
  [[nodiscard]] bool commentBelongsToNext(Index comment, Index parent) const;
  void betterOf(const std::function<void()>& first, const std::function<void()>& second);

  std::string_view text;
  std::vector<Trailing> trailing;
  const Boxes* boxes = nullptr;
  Offset previousEnd = 0;
  std::uint32_t column = 0;
  std::uint32_t widest = 0;  ///< the greatest column reached
  std::uint32_t written = 0; ///< number of line ends
  bool lineMustEnd = false;  ///< the last token was a comment
  bool frozen = false;       ///< the last region stays as it is, including the space after it
  bool lastWasForm = false;  ///< at the top level
  bool lastWasTall = false;  ///< it takes several lines
};

} // namespace proskill::syntax
