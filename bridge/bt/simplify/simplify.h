#pragma once

#include "bridge/text/form.h"

#include <set>
#include <string>

namespace proskill::bridge::bt {

/// A program without the statements that no run reaches, without the tests whose result is always
/// the same, and without the composite skills that nothing calls. The statements for a node do not
/// know those before them, so some are written that cannot be reached. Basic skills stay: that a
/// tree never ticks one is for its author to know. Declares the outcomes of composite skills.
/// \param mission the skill that nothing calls
[[nodiscard]] Block simplified(Block program, const std::string& mission);

/// The skills that the composite skills of a program call.
[[nodiscard]] std::set<std::string> calledIn(const Block& program);

} // namespace proskill::bridge::bt
