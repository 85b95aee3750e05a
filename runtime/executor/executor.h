#pragma once

#include "runtime/clock/clock.h"
#include "runtime/executor/observer.h"
#include "runtime/executor/run_options.h"

namespace proskill::runtime {

/// Executes a program. Urgent steps are taken at once, steps with a time at that time, and steps of
/// the platform when it reports them. A step with a time has that date even if this process woke up
/// later.
/// \pre the arguments outlive the call
[[nodiscard]] RunResult execute(const Executable& executable, Clock& clock, Platform& platform,
                                Observer& observer, const RunOptions& options);

} // namespace proskill::runtime
