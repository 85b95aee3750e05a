#pragma once

#include "verify/compile/elaborate.h"

namespace proskill::verify {

/// Whether only an observer takes part in the transition.
[[nodiscard]] bool observes(const Elaboration& model, const System& system,
                            const Transition& transition);

/// Computes which transitions have priority over each transition: by priorities between ports, by
/// `unless` between silent paths, and observers over the model.
/// \throw CompileError if a port has priority over itself
void addPriorities(const Elaboration& model, System& system);

} // namespace proskill::verify
