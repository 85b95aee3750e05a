#pragma once

#include "ide/verdicts/verdicts.h"

#include <string>
#include <vector>

namespace proskill::ide {

enum class LensKind : std::uint8_t {
  References, ///< counted when somebody looks at it
  Automaton,
  Verify,
  Verdicts,
};

/// A line above a definition that leads somewhere.
struct Lens {
  LensKind kind = LensKind::References;
  analysis::SymbolId symbol = analysis::kNoSymbol; ///< kNoSymbol in Fiacre
  syntax::Range at;                                ///< the definition's name
  std::string title;                               ///< empty of references
  std::string property; ///< Verdicts: the one whose trace is worth a look; empty: there is none
  std::string name{};   ///< without a symbol: of which property; empty: of all
};

/// The lenses of a file, in the order of the text. Verdicts are those for the texts as they are, or
/// are called stale. \param verdicts of all programs
[[nodiscard]] std::vector<Lens> lenses(const View& view, const Verdicts& verdicts);

/// "3 references", without the definition itself.
[[nodiscard]] std::string referencesTitle(std::size_t count);

} // namespace proskill::ide
