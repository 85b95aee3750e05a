#pragma once

#include "ide/description/markup.h"
#include "ide/snapshot/snapshot.h"

#include <string>

/// What is told of a symbol, whatever feature tells it.
namespace proskill::ide {

/// One line of code: `(takeoff height float duration float)`, `battery: Good Low Critical`.
[[nodiscard]] std::string signature(const View& view, analysis::SymbolId symbol);

/// The lines of comment directly above the definition, without their semicolons; empty where there
/// are none.
[[nodiscard]] std::string commentAbove(const View& view, analysis::SymbolId symbol);

/// A state variable's values as a person writes them: `Good Low Critical`, `0..10`.
[[nodiscard]] std::string valuesOf(const syntax::StateVariable& variable);

/// The definition as code, the comment, the type, the allowed moves, and who uses it how.
void describe(Markup& text, const View& view, analysis::SymbolId symbol);

} // namespace proskill::ide
