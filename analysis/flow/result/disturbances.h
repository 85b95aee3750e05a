#pragma once

#include "analysis/flow/engine/system.h"

namespace proskill::analysis::flow {

/// Whether others may end the thread at once: by a guard of a caller, by a parallel branch that
/// ends the skill or wins a race, or by an interrupt. \pre it has a graph
[[nodiscard]] bool mayBeEnded(const System& system, ProcessId thread);

/// Whether others may delay the call: they call the same skill, or hold what it needs.
[[nodiscard]] bool mayBeHeldUp(const System& system, ProcessId caller, ProcessId callee);

} // namespace proskill::analysis::flow
