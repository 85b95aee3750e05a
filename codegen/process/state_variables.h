#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// The automaton of a state variable. Exact: it moves to `error` at once when a forbidden move has
/// raised the alarm. Paper: it has a state for each value and polls the variable.
/// \pre all effects have been translated, so that it is known which variables have an alarm
[[nodiscard]] fiacre::Process
stateVariableAutomaton(Context& context,
                       const analysis::Definition<syntax::StateVariable>& variable);

/// The type of a state variable: a union of its values, or a range.
[[nodiscard]] fiacre::TypeDeclaration
stateVariableType(Context& context, const analysis::Definition<syntax::StateVariable>& variable);

/// Its initial value.
[[nodiscard]] fiacre::Expr initialValue(Context& context, const syntax::StateVariable& variable);

/// The port that is passed when all values have been chosen; nothing else happens before.
[[nodiscard]] const std::string& beginPort(Context& context);
/// The state of `initialChoice` from then on.
inline constexpr const char* kChosen = "chosen";
/// Who chooses, and then calls the mission and the monitors.
[[nodiscard]] fiacre::Process initialChoice(Context& context);
/// Has a process begin when all values have been chosen.
void holdBack(Context& context, fiacre::Process& process);

} // namespace proskill::codegen
