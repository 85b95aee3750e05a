#pragma once

#include "verify/export/promela_model.h"

namespace proskill::verify {

/// A transition as an option of the loop of a process: `:: d_step { … }`.
/// \throw CompileError if Promela cannot express it
[[nodiscard]] std::string promelaStep(PromelaModel& model, TransitionId id);

/// A step of time.
/// \pre the model has time
[[nodiscard]] std::string promelaTick(const PromelaModel& model);

/// A macro for each clock: whether it runs in the discrete state.
[[nodiscard]] std::string clockMacros(const PromelaModel& model);

/// Checks that a state fulfils an assertion. \return nothing if it is not about states
[[nodiscard]] std::optional<std::string> assertedOfState(const PromelaModel& model,
                                                         const PromelaAssertion& assertion);

} // namespace proskill::verify
