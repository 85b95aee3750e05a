#pragma once

#include "analysis/names/index.h"
#include "analysis/names/scope.h"
#include "analysis/names/symbol_change.h"
#include "syntax/text/change.h"

#include <optional>

namespace proskill::analysis {

/// What of an earlier analysis holds after an edit. Looked at again are the definitions whose text
/// has changed, and those that have a word of which the meaning may be another now: the names that
/// came and went, and those of definitions of which others see more than the name and the parts.
class Reuse {
public:
  /// Nothing where the edit may matter anywhere.
  [[nodiscard]] static std::optional<Reuse> find(const Earlier& earlier, const Program& now,
                                                 const SymbolTable& symbols);

  /// The definitions to be looked at.
  [[nodiscard]] const Scope& scope() const { return looked; }
  /// What a check of definitions has found, but for those that are looked at again.
  [[nodiscard]] const std::vector<Found>& found() const { return kept; }
  /// \param noted in the definitions that were looked at
  [[nodiscard]] Index index(SymbolTable symbols, std::vector<Occurrence> noted) &&;

private:
  Reuse(FileId file, syntax::Replacement edit, Scope looked, SymbolChange symbols);

  bool keep(const std::vector<Found>& found);
  bool keep(const Found& found);
  bool keep(std::span<const Occurrence> occurrences);
  [[nodiscard]] bool isGone(const Location& at) const;
  bool moveSymbol(SymbolId& symbol) const;

  FileId file;
  syntax::Replacement edit;
  Scope looked; ///< in the new texts
  Scope gone;   ///< the same in the old ones
  SymbolChange symbols;
  std::vector<Found> kept;
  std::vector<Occurrence> places;
};

/// The one file in which a program differs from what it was, and how.
struct FileChange {
  FileId file = 0;
  syntax::Change change;
};
/// Nothing where the programs differ in several files or in which files they are of.
[[nodiscard]] std::optional<FileChange> changeBetween(const Program& before, const Program& now);

/// The diagnostics at their new places, after an edit of white space or comments. Nothing where one
/// of them may have another text or another fix now.
[[nodiscard]] std::optional<std::vector<syntax::Diagnostic>>
movedByLayout(const std::vector<syntax::Diagnostic>& diagnostics, const FileChange& edit);

} // namespace proskill::analysis
