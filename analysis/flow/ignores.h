#pragma once

#include "analysis/program/program.h"

#include <vector>

namespace proskill::analysis::flow {

/// Removes the diagnostics that a comment `; proskill-ignore: PS0708` on the previous line asks to
/// ignore. Adds hints about such comments that ignore nothing or name no code. Errors of form,
/// names and types cannot be ignored, because a program with such errors has no meaning.
[[nodiscard]] std::vector<syntax::Diagnostic>
withoutIgnored(const Program& program, std::vector<syntax::Diagnostic> diagnostics);

} // namespace proskill::analysis::flow
