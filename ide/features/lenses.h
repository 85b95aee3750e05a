#pragma once

#include "ide/verdicts/verdicts.h"

#include <string>
#include <vector>

namespace proskill::ide {

enum class LensKind : std::uint8_t {
  References, ///< counted on demand
  Automaton,
  Verify,
  Verdicts,
};

/// A code lens: a line above a definition with a link.
struct Lens {
  LensKind kind = LensKind::References;
  analysis::SymbolId symbol = analysis::kNoSymbol; ///< kNoSymbol in Fiacre
  syntax::Range at;                                ///< the name of the definition
  std::string title;                               ///< empty for References
  std::string property; ///< Verdicts: the property whose trace is most useful; empty: none
  std::string name{};   ///< if there is no symbol: the property; empty: all properties
};

/// Editors move all lenses of a file at each key, which takes time where there are thousands.
constexpr std::size_t kMostWithLenses = 400;

/// The lenses of a file, in the order of the text. Verdicts for other versions of the texts are
/// marked as stale. A file with more than `kMostWithLenses` definitions has lenses for properties
/// and composite skills, and for the other skills if these are not too many.
/// \param verdicts of all programs
[[nodiscard]] std::vector<Lens> lenses(const View& view, const Verdicts& verdicts);

/// "3 references", without the definition itself.
[[nodiscard]] std::string referencesTitle(std::size_t count);

} // namespace proskill::ide
