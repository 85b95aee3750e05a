#pragma once

#include "verify/compile/elaborate.h"

namespace proskill::verify {

/// Whether a step is one of an observer's alone.
[[nodiscard]] bool observes(const Elaboration& model, const System& system,
                            const Transition& transition);

/// Notes for each transition which others go before it: by priorities between ports, by `unless`
/// between silent paths, and observers before the model. \throw CompileError where a port has
/// priority over itself
void addPriorities(const Elaboration& model, System& system);

} // namespace proskill::verify
