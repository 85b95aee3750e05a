#pragma once

#include "analysis/index.h"
#include "analysis/names.h"
#include "syntax/change.h"

#include <optional>

namespace proskill::analysis {

/// What of an earlier analysis holds after an edit. A definition is looked at again where its text
/// has changed; the others refer to it by its name, its parts and its inputs only, so that these
/// must be the same.
class Reuse {
public:
  /// Nothing where the edit may matter anywhere.
  [[nodiscard]] static std::optional<Reuse> find(const Earlier& earlier, const Program& now,
                                                 const SymbolTable& symbols);

  /// The definitions to be looked at.
  [[nodiscard]] Scope scope() const;
  /// What a check of definitions has found, but for those that are looked at again.
  [[nodiscard]] const std::vector<Found>& found() const { return kept; }
  [[nodiscard]] Index index(SymbolTable symbols, std::vector<Occurrence> occurrences) const;

private:
  Reuse(const Index& before, FileId file, syntax::Replacement edit, bool isLayout)
      : before(before), file(file), edit(edit), isLayout(isLayout) {}

  bool keep(const Found& found);

  const Index& before;
  FileId file;
  syntax::Replacement edit;
  bool isLayout;
  std::vector<Found> kept;
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
