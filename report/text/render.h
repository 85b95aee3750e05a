#pragma once

#include "analysis/program/program.h"
#include "report/text/paint.h"

#include <iosfwd>
#include <span>
#include <string_view>

namespace proskill::report {

/// "error", "warning", "hint".
[[nodiscard]] std::string_view words(syntax::Severity severity);

/// Prints a diagnostic for a terminal: code and message, the place, the source with carets below
/// it, related places, and fixes.
void render(std::ostream& out, const analysis::Program& program,
            std::span<const syntax::Diagnostic> diagnostics, const Paint& paint);

} // namespace proskill::report
