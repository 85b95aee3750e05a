#pragma once

#include "verify/model/goals.h"

namespace proskill::verify {

/// Whether a step that changes nothing which the monitor sees is nothing to it: its points are
/// those of the state around it, and no run without end is asked for.
[[nodiscard]] bool watchesPoints(const Monitor& monitor);

/// What a monitor looks at, as goals are known to the reductions.
[[nodiscard]] std::vector<Goal> goalsOf(const Monitor& monitor);

/// The transitions with which the monitor has to move. \pre the system has a state layout
[[nodiscard]] Bits stepsSeenBy(const Monitor& monitor, const System& system);

} // namespace proskill::verify
