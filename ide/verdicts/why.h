#pragma once

#include "ide/verdicts/verification.h"

/// Why things happen in a trace, in the program's words. All of it is read off what was computed
/// (verify/trace/causes.h); where nothing is known, nothing is said.
namespace proskill::ide {

/// For each step a sentence, or nothing.
[[nodiscard]] std::vector<std::string> whyOf(const verify::Trace& trace,
                                             const codegen::Model& model);

/// What the trace shows of the property, in a sentence.
/// \param support what the condition at its end was decided by
[[nodiscard]] std::string summaryOf(const codegen::Check& check, const codegen::Model& model,
                                    const Trace& trace,
                                    const std::vector<verify::Support>& support);

} // namespace proskill::ide
