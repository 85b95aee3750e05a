#pragma once

#include "analysis/program/program.h"

#include <vector>

namespace proskill::analysis::flow {

/// Takes out the diagnostics that a comment `; proskill-ignore: PS0708` on the line before asks to
/// leave out, and adds hints about such comments that leave out nothing or name no code. Errors of
/// form, names and types stay: a program with them means nothing.
[[nodiscard]] std::vector<syntax::Diagnostic>
withoutIgnored(const Program& program, std::vector<syntax::Diagnostic> diagnostics);

} // namespace proskill::analysis::flow
