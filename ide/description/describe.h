#pragma once

#include "ide/description/markup.h"
#include "ide/snapshot/snapshot.h"

#include <string>

/// Descriptions of symbols, for all features.
namespace proskill::ide {

/// One line of code: `(takeoff height float duration float)`, `battery: Good Low Critical`.
[[nodiscard]] std::string signature(const View& view, analysis::SymbolId symbol);

/// The comment lines directly above the definition, without their semicolons; empty if there are
/// none.
[[nodiscard]] std::string commentAbove(const View& view, analysis::SymbolId symbol);

/// A state variable's values as written: `Good Low Critical`, `0..10`.
[[nodiscard]] std::string valuesOf(const syntax::StateVariable& variable);

/// Appends the definition as code, its comment, its type, the allowed transitions, and its users.
void describe(Markup& text, const View& view, analysis::SymbolId symbol);

} // namespace proskill::ide
