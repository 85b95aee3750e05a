#pragma once

#include "report/text/paint.h"
#include "syntax/document.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace proskill::report {

/// A marked part of a text, with a label.
struct Mark {
  syntax::Range range;
  std::string label; ///< may be empty
  bool primary = false;
};

/// Lines of a text with marks below them.
///
///     12 |   (takeoff height 3.0 height 4.0)
///        |            ------     ^^^^^^
///        |            |
///        |            first given here
///
/// A mark over several lines is drawn at its first and its last one. Of a very long line only what
/// is around the marks is shown.
class Snippet {
public:
  Snippet(const syntax::Document& document, const std::vector<Mark>& marks);

  /// The number of columns for the greatest line number.
  [[nodiscard]] std::size_t gutterWidth() const;
  /// \param primary the colour of primary marks; the others are blue
  void print(std::ostream& out, std::size_t gutter, const Paint& paint, Colour primary) const;

private:
  /// A mark within one line, in bytes of the text.
  struct Piece {
    syntax::Range range;
    std::string label;
    bool primary;
  };
  struct Line {
    std::uint32_t number; ///< from 0
    syntax::Range shown;  ///< bytes of the text: the line or a part of it
    std::vector<Piece> pieces;
  };

  void add(const Mark& mark);
  void addPiece(std::uint32_t line, const Piece& piece);
  [[nodiscard]] syntax::Range windowAround(syntax::Range line, syntax::Range piece) const;

  const syntax::Document& document;
  std::vector<Line> lines;
};

} // namespace proskill::report
