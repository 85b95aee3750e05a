#pragma once

#include "analysis/index.h"

#include <vector>

namespace proskill::analysis::flow {

/// What is wrong with the values, the flow and the time of a program: PS05xx to PS11xx, in the
/// order of the files. \pre the program has no errors of form, names or types.
[[nodiscard]] std::vector<syntax::Diagnostic> checkFlow(const Program& program, const Index& index);

} // namespace proskill::analysis::flow
