#pragma once

#include "ide/verdicts/verification.h"

/// Explains in the program's terms why things happen in a trace. Explanations come only from
/// computed causes (verify/trace/causes.h).
namespace proskill::ide {

/// By step: the reason as text; empty if none is known.
[[nodiscard]] std::vector<std::string> whyOf(const verify::Trace& trace,
                                             const codegen::Model& model);

/// What the trace shows about the property, as a sentence.
/// \param support facts that decided the condition at its end
[[nodiscard]] std::string summaryOf(const codegen::Check& check, const codegen::Model& model,
                                    const Trace& trace,
                                    const std::vector<verify::Support>& support);

} // namespace proskill::ide
