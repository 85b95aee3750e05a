#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// A step that does not depend on the mission and is always possible, now or later:
/// "`opens` can always occur". With one, no state of the program is a deadlock, wherever its
/// mission has stopped. Empty if there is none, or if there is no mission.
[[nodiscard]] std::string alwaysPossible(const Context& context);

} // namespace proskill::codegen
