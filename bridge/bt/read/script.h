#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace proskill::bridge::bt {

/// What is wrong with a script of BehaviorTree.CPP: statements between `;`, each an expression or
/// an assignment of one to an entry of the blackboard. \return nothing if the script has the form
/// of one; what its names mean is not checked
[[nodiscard]] std::optional<std::string> scriptError(std::string_view code);

} // namespace proskill::bridge::bt
