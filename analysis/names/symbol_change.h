#pragma once

#include "analysis/names/symbols.h"

#include <set>
#include <string_view>
#include <vector>

namespace proskill::analysis {

/// How the symbols of a program have changed.
struct SymbolChange {
  std::vector<SymbolId> now; ///< by old symbol; kNoSymbol if it was removed
  /// Names whose meaning may have changed in other definitions: names of definitions that were
  /// added, removed or got other parts, and of labels among these parts, which are named without an
  /// owner. A definition that uses another kind of part also contains the name of the part's owner,
  /// or of a skill with an input of this type. The names refer to the texts of both tables.
  std::set<std::string_view> names;
};

/// Definitions are matched by kind, name and order; their parts likewise.
[[nodiscard]] SymbolChange changeBetween(const SymbolTable& before, const SymbolTable& now);

} // namespace proskill::analysis
