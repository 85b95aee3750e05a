#pragma once

#include "verify/model/goals.h"
#include "verify/verify.h"

namespace proskill::verify {

/// Whether the monitor ignores steps that change nothing it reads: it reads such a step like the
/// state around it, and it does not accept infinite runs.
[[nodiscard]] bool watchesPoints(const Monitor& monitor);

/// Whether adding or removing steps that change nothing the monitor reads does not affect whether
/// it accepts a fair run: it reads states only, and time passes between the steps.
[[nodiscard]] bool watchesStates(const Monitor& monitor, const System& system);

/// Whether a reduction preserves everything that the monitor observes.
[[nodiscard]] bool suits(const Monitor& monitor, Reduction reduction, const System& system);

/// The conditions of a monitor as goals for the reductions.
[[nodiscard]] std::vector<Goal> goalsOf(const Monitor& monitor);

/// The transitions that the monitor must not miss. \pre the system has a state layout
[[nodiscard]] Bits stepsSeenBy(const Monitor& monitor, const System& system);

} // namespace proskill::verify
