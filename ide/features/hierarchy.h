#pragma once

#include "ide/snapshot/snapshot.h"

#include <optional>
#include <vector>

/// Who calls whom, and who uses which state variable.
namespace proskill::ide {

/// A definition at the other end, and the places that link the two.
struct Link {
  analysis::SymbolId symbol = analysis::kNoSymbol;
  std::vector<analysis::Location> places; ///< all in one file
};

/// The skill whose name stands at a place.
[[nodiscard]] std::optional<analysis::SymbolId> skillAt(const View& view, syntax::Offset at);
/// The skills whose bodies call the skill; the places are their calls.
[[nodiscard]] std::vector<Link> incomingCalls(const View& view, analysis::SymbolId skill);
/// The skills that the skill's body calls; the places are its calls.
[[nodiscard]] std::vector<Link> outgoingCalls(const View& view, analysis::SymbolId skill);

/// The state variable, or the skill, event, environment or property that uses some, whose name
/// stands at a place.
[[nodiscard]] std::optional<analysis::SymbolId> userOrVariableAt(const View& view,
                                                                 syntax::Offset at);
/// The definitions that look at a state variable or set it; empty for anything else.
[[nodiscard]] std::vector<Link> usersOfVariable(const View& view, analysis::SymbolId variable);
/// The state variables that a definition looks at or sets.
[[nodiscard]] std::vector<Link> variablesOf(const View& view, analysis::SymbolId user);

} // namespace proskill::ide
