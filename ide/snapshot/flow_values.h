#pragma once

#include "ide/snapshot/snapshot.h"

#include <optional>
#include <string>

/// What the flow of a program tells about a place, in words.
namespace proskill::ide {

/// The flow where it is known already, or is quickly computed: an answer that somebody waits for
/// does not wait for a large program. Null else, and in a program with errors.
[[nodiscard]] std::shared_ptr<const KnownFlow> quickFlow(const View& view);

/// The variable of the flow that a name stands for: a state variable's name, or `skill.status` and
/// `skill.res`.
[[nodiscard]] std::optional<analysis::flow::VariableId>
flowVariable(const View& view, const KnownFlow& flow, std::string_view text);

/// "Here it is `Good` or `Low`." or that the place is never reached; empty where nothing is known
/// that the definition does not say.
[[nodiscard]] std::string valuesHere(const View& view, analysis::Location place,
                                     std::string_view text);

/// What the variable may be in all runs, where that is less than its definition says.
[[nodiscard]] std::string valuesEver(const View& view, std::string_view text);

} // namespace proskill::ide
