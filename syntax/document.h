#pragma once

#include "syntax/diagnostics/diagnostic.h"
#include "syntax/text/change.h"
#include "syntax/tree/form.h"
#include "syntax/tree/tree.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::syntax {

/// The longest text that is read, in bytes; a longer one gives a document without forms that says
/// so.
inline constexpr std::uint64_t kLongestText = 0xffff'ffff;

/// A part of a text that was read on its own: at most one definition, where each starts a line.
struct Region {
  Range range;
  /// Its ranges count from the region's begin. A region that edits did not touch has one and the
  /// same tree in all documents that came of them, wherever it stands, and no other has it.
  std::shared_ptr<const Tree> tree;
  bool readAsIs = false; ///< nothing had to be put in or left out before it could be read
};

/// A parsed text: a value, never changed, cheap to copy. Parsing never fails.
class Document {
public:
  /// Any bytes give a document.
  static Document parse(std::string text);

  /// The document after `range` was replaced by `text`: equal to a fresh parse of the new text, at
  /// the cost of the forms that the edit touches.
  [[nodiscard]] Document edit(Range range, std::string_view text) const;

  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] const LineIndex& lines() const;
  /// The forms in the order of the text, with absolute ranges.
  [[nodiscard]] const std::vector<Form>& forms() const;
  /// Those that begin in a range.
  [[nodiscard]] std::span<const Form> formsIn(Range range) const;
  /// Comments in the order of the text, from `;` to the end of the line, without the line's end.
  [[nodiscard]] const std::vector<Range>& comments() const;
  /// What is wrong with the form of the text; `Location::file` is 0.
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const;
  /// They cover the text, in its order.
  [[nodiscard]] std::vector<Region> regions() const;
  /// Whether this is a copy of the other, or it of this. Two parses of one text are not the same.
  [[nodiscard]] bool isSameAs(const Document& other) const { return state == other.state; }
  /// How this came from another document: cheap where it was edited, whatever the number of edits.
  [[nodiscard]] Change changeFrom(const Document& before) const;
  /// The concrete trees as one S-expression with ranges, for tests and for debugging.
  [[nodiscard]] std::string dump() const;

private:
  struct State;
  std::shared_ptr<const State> state;
};

} // namespace proskill::syntax
