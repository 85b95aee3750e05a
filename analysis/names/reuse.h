#pragma once

#include "analysis/names/index.h"
#include "analysis/names/scope.h"
#include "analysis/names/symbol_change.h"
#include "syntax/text/change.h"

#include <optional>

namespace proskill::analysis {

/// Decides which parts of an earlier analysis remain valid after an edit. Checked again are:
/// definitions whose text has changed, and definitions with a word whose meaning may have changed.
/// Such words are names that were added or removed, and names of definitions of which other
/// definitions read more than the name and the parts.
class Reuse {
public:
  /// Nothing if the edit may affect everything.
  [[nodiscard]] static std::optional<Reuse> find(const Earlier& earlier, const Program& now,
                                                 const SymbolTable& symbols);

  /// The definitions that must be checked again.
  [[nodiscard]] const Scope& scope() const { return looked; }
  /// The findings of a check for all other definitions.
  [[nodiscard]] const std::vector<Found>& found() const { return kept; }
  /// \param noted occurrences in the definitions that were checked again
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

/// The only file in which two versions of a program differ, and the difference.
struct FileChange {
  FileId file = 0;
  syntax::Change change;
};
/// Nothing if the programs differ in several files, or consist of different files.
[[nodiscard]] std::optional<FileChange> changeBetween(const Program& before, const Program& now);

/// The diagnostics at their new places after an edit of white space or comments. Nothing if the
/// text or the fix of one may have changed.
[[nodiscard]] std::optional<std::vector<syntax::Diagnostic>>
movedByLayout(const std::vector<syntax::Diagnostic>& diagnostics, const FileChange& edit);

} // namespace proskill::analysis
