#pragma once

#include "ide/snapshot/snapshot.h"

#include <optional>
#include <vector>

/// Hierarchies: which skills call which, and which definitions use which state variables.
namespace proskill::ide {

/// A related definition, and the places that relate it.
struct Link {
  analysis::SymbolId symbol = analysis::kNoSymbol;
  std::vector<analysis::Location> places; ///< all in the same file
};

/// The skill that is named at a place.
[[nodiscard]] std::optional<analysis::SymbolId> skillAt(const View& view, syntax::Offset at);
/// The skills that call the skill, with the places of their calls.
[[nodiscard]] std::vector<Link> incomingCalls(const View& view, analysis::SymbolId skill);
/// The skills that the skill's body calls, with the places of these calls.
[[nodiscard]] std::vector<Link> outgoingCalls(const View& view, analysis::SymbolId skill);

/// The symbol at a place: a state variable, or a skill, event, environment or property that uses
/// state variables.
[[nodiscard]] std::optional<analysis::SymbolId> userOrVariableAt(const View& view,
                                                                 syntax::Offset at);
/// The definitions that read or set a state variable; empty for other symbols.
[[nodiscard]] std::vector<Link> usersOfVariable(const View& view, analysis::SymbolId variable);
/// The state variables that a definition reads or sets.
[[nodiscard]] std::vector<Link> variablesOf(const View& view, analysis::SymbolId user);

} // namespace proskill::ide
