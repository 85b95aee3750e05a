#pragma once

#include "ide/snapshot/snapshot.h"

#include <optional>
#include <string>

/// Texts about the possible values at a place.
namespace proskill::ide {

/// The flow if it is known or quickly computed, so that no answer has to wait for a large program.
/// Otherwise, and for programs with errors, null.
[[nodiscard]] std::shared_ptr<const KnownFlow> quickFlow(const View& view);

/// The flow variable of a name: a state variable's name, or `skill.status` and `skill.res`.
[[nodiscard]] std::optional<analysis::flow::VariableId>
flowVariable(const View& view, const KnownFlow& flow, std::string_view text);

/// "Here it is `Good` or `Low`.", or that the place is unreachable. Empty if this adds nothing to
/// the definition.
[[nodiscard]] std::string valuesHere(const View& view, analysis::Location place,
                                     std::string_view text);

/// The possible values of the variable in all runs, if they are fewer than in its definition.
[[nodiscard]] std::string valuesEver(const View& view, std::string_view text);

} // namespace proskill::ide
