#pragma once

#include "ide/snapshot/snapshot.h"

#include <string>
#include <vector>

namespace proskill::ide {

/// An entry of a file's outline.
struct OutlineEntry {
  std::string name; ///< never empty: what has no name yet is called by its keyword
  std::string detail;
  analysis::SymbolKind kind = analysis::SymbolKind::Skill;
  bool isFile = false;     ///< an include; `kind` means nothing
  syntax::Range range;     ///< of the whole definition
  syntax::Range selection; ///< of its name, within `range`
  std::vector<OutlineEntry> children;
};

/// The definitions of a file with what is defined inside of them, in the order of the text.
[[nodiscard]] std::vector<OutlineEntry> outline(const View& view);
/// Those that begin in a range. Of a region, they depend on its text alone.
[[nodiscard]] std::vector<OutlineEntry> outline(const View& view, syntax::Range within);

struct FoundSymbol {
  std::string name;
  analysis::SymbolKind kind = analysis::SymbolKind::Skill;
  std::filesystem::path file;
  syntax::Range at;                   ///< as the file was when it was last read
  std::optional<std::string> owner{}; ///< the name of what it is inside of
};

/// The symbols of all files of the workspace, and of those that they include, whose names match,
/// best first, at most 256; inputs and tags are found under the names of their skills alone. An
/// empty query matches everything. No program is looked at.
/// \param isCancelled is asked now and then; what was found so far is given
[[nodiscard]] std::vector<FoundSymbol> workspaceSymbols(const Snapshot& snapshot,
                                                        std::string_view query,
                                                        const std::function<bool()>& isCancelled);

} // namespace proskill::ide
