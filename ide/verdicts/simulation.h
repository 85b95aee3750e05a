#pragma once

#include "ide/verdicts/verification.h"
#include "verify/trace/simulation.h"

namespace proskill::ide {

/// What may come next in a simulation, in the program's words, each as the step that it would be.
/// \param before the date of the last step, in seconds
[[nodiscard]] std::vector<TraceStep> inWords(const std::vector<verify::Choice>& choices,
                                             const codegen::Model& model, syntax::Rational before);

} // namespace proskill::ide
