#pragma once

#include "cli/paint.h"
#include "codegen/model.h"

#include <iosfwd>
#include <span>
#include <string_view>

namespace proskill::cli {

/// "error", "warning", "hint".
[[nodiscard]] std::string_view words(syntax::Severity severity);

/// Prints diagnostics for people: code and message, the place, the source with carets below it, the
/// related places, and what would mend it.
void render(std::ostream& out, const analysis::Program& program,
            std::span<const syntax::Diagnostic> diagnostics, const Paint& paint);

/// Says on standard error why there is no model of a program. The exit code: 2.
int failGeneration(const analysis::Program& program, const codegen::GenerationError& error);

} // namespace proskill::cli
