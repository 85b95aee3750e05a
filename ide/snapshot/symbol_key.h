#pragma once

#include "ide/snapshot/snapshot.h"

#include <optional>
#include <string>

namespace proskill::ide {

/// A symbol by its names: finds the same thing again after an edit, where a number would not.
struct SymbolKey {
  analysis::SymbolKind kind = analysis::SymbolKind::Skill;
  std::string name;
  std::string owner; ///< the name of what it is inside of; empty at the top level

  friend bool operator==(const SymbolKey&, const SymbolKey&) = default;
};

[[nodiscard]] SymbolKey keyOf(const analysis::SymbolTable& symbols, analysis::SymbolId symbol);
/// None where the program has no such symbol.
[[nodiscard]] analysis::SymbolId findSymbol(const analysis::SymbolTable& symbols,
                                            const SymbolKey& key);

/// The definition at the top level that a place stands in; none where it stands in none.
[[nodiscard]] analysis::SymbolId definitionAround(const View& view, analysis::Location place);

/// The symbol that a form defines; none where it defines none.
[[nodiscard]] analysis::SymbolId symbolOf(const View& view, analysis::FileId file,
                                          const syntax::Form& form);

} // namespace proskill::ide
