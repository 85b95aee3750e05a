#pragma once

#include "ide/snapshot/snapshot.h"

#include <string>
#include <vector>

namespace proskill::ide {

/// An entry of a file's outline.
struct OutlineEntry {
  std::string name; ///< never empty: a definition without a name has its keyword
  std::string detail;
  analysis::SymbolKind kind = analysis::SymbolKind::Skill;
  bool isFile = false;     ///< an include; `kind` is undefined
  syntax::Range range;     ///< of the whole definition
  syntax::Range selection; ///< of its name, within `range`
  std::vector<OutlineEntry> children;
};

/// The definitions of a file and their parts, in the order of the text.
[[nodiscard]] std::vector<OutlineEntry> outline(const View& view);
/// The entries that begin in a range. For a region, they depend only on its text.
[[nodiscard]] std::vector<OutlineEntry> outline(const View& view, syntax::Range within);

struct FoundSymbol {
  std::string name;
  analysis::SymbolKind kind = analysis::SymbolKind::Skill;
  std::filesystem::path file;
  syntax::Range at;                   ///< in the last read version of the file
  std::optional<std::string> owner{}; ///< the name of the enclosing definition
};

/// The symbols that match a query, of all files of the workspace and of their includes; best first,
/// at most 256. Inputs and tags are found only together with the names of their skills. An empty
/// query matches everything. No program is analysed.
/// \param isCancelled called from time to time; if it returns true, the symbols found so far are
/// returned
[[nodiscard]] std::vector<FoundSymbol> workspaceSymbols(const Snapshot& snapshot,
                                                        std::string_view query,
                                                        const std::function<bool()>& isCancelled);

} // namespace proskill::ide
