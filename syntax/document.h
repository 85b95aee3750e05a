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

/// Maximal length of a text, in bytes. A longer text gives a document without forms, and a
/// diagnostic.
inline constexpr std::uint64_t kLongestText = 0xffff'ffff;

/// A part of a text that is parsed separately: at most one definition, if definitions start lines.
struct Region {
  Range range;
  /// Ranges count from the region's begin. A region that edits did not touch shares one tree with
  /// all later documents, wherever it is; no other region has this tree.
  std::shared_ptr<const Tree> tree;
  bool readAsIs = false; ///< nothing had to be inserted or removed to parse it
};

/// A parsed text. It is an immutable value and cheap to copy. Parsing never fails.
class Document {
public:
  /// Parses any bytes.
  static Document parse(std::string text);

  /// The document after `range` is replaced by `text`. It is equal to a fresh parse of the new
  /// text, but only the forms that the edit touches are parsed.
  [[nodiscard]] Document edit(Range range, std::string_view text) const;

  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] const LineIndex& lines() const;
  /// The forms in the order of the text, with absolute ranges.
  [[nodiscard]] const std::vector<Form>& forms() const;
  /// The forms that begin in a range.
  [[nodiscard]] std::span<const Form> formsIn(Range range) const;
  /// Comments in the order of the text, from `;` to the end of the line, without the line's end.
  [[nodiscard]] const std::vector<Range>& comments() const;
  /// Syntax errors; `Location::file` is 0.
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const;
  /// The regions, in the order of the text; together they cover it.
  [[nodiscard]] std::vector<Region> regions() const;
  /// Whether one is a copy of the other. Two parses of the same text are different.
  [[nodiscard]] bool isSameAs(const Document& other) const { return state == other.state; }
  /// The change from another document to this one. Cheap if one was edited into the other, whatever
  /// the number of edits.
  [[nodiscard]] Change changeFrom(const Document& before) const;
  /// The concrete trees as an S-expression with ranges, for tests and debugging.
  [[nodiscard]] std::string dump() const;

private:
  struct State;
  std::shared_ptr<const State> state;
};

} // namespace proskill::syntax
