#pragma once

#include "ide/snapshot/snapshot.h"

#include <optional>
#include <string>

namespace proskill::ide {

/// Identifies a symbol by its names, so that it can be found again after an edit.
struct SymbolKey {
  analysis::SymbolKind kind = analysis::SymbolKind::Skill;
  std::string name;
  std::string owner; ///< the name of the enclosing definition; empty at the top level

  friend bool operator==(const SymbolKey&, const SymbolKey&) = default;
};

[[nodiscard]] SymbolKey keyOf(const analysis::SymbolTable& symbols, analysis::SymbolId symbol);
/// kNoSymbol if the program has no such symbol.
[[nodiscard]] analysis::SymbolId findSymbol(const analysis::SymbolTable& symbols,
                                            const SymbolKey& key);

/// The top-level definition that contains a place; kNoSymbol if there is none.
[[nodiscard]] analysis::SymbolId definitionAround(const View& view, analysis::Location place);

/// The symbol that a form defines; kNoSymbol if it defines none.
[[nodiscard]] analysis::SymbolId symbolOf(const View& view, analysis::FileId file,
                                          const syntax::Form& form);

} // namespace proskill::ide
