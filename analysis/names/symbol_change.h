#pragma once

#include "analysis/names/symbols.h"

#include <set>
#include <string_view>
#include <vector>

namespace proskill::analysis {

/// What became of the symbols of a program.
struct SymbolChange {
  std::vector<SymbolId> now; ///< of each of the old ones; kNoSymbol where it is gone
  /// Names of which the meaning may have changed elsewhere: of the definitions that came and went
  /// or have other parts, and of the labels among these, which stand alone. Who has another part
  /// has the name of its owner, or of a skill with an input of that type. They look into both
  /// tables' texts.
  std::set<std::string_view> names;
};

/// Definitions are matched by their kind, name and order, their parts likewise.
[[nodiscard]] SymbolChange changeBetween(const SymbolTable& before, const SymbolTable& now);

} // namespace proskill::analysis
