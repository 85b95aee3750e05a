#pragma once

#include "verify/model/goals.h"

namespace proskill::verify {

/// Whether a step that changes nothing which the monitor sees is nothing to it: its points are
/// those of the state around it, and no run without end is asked for.
[[nodiscard]] bool watchesPoints(const Monitor& monitor);

/// Whether a fair run stays what it is to the monitor when steps that change nothing which it sees
/// are put in or left out: it watches states, and time goes on between the steps.
[[nodiscard]] bool watchesStates(const Monitor& monitor, const System& system);

/// What a monitor looks at, as goals are known to the reductions.
[[nodiscard]] std::vector<Goal> goalsOf(const Monitor& monitor);

/// The transitions with which the monitor has to move. \pre the system has a state layout
[[nodiscard]] Bits stepsSeenBy(const Monitor& monitor, const System& system);

} // namespace proskill::verify
