#pragma once

#include "syntax/diagnostics/diagnostic.h"
#include "syntax/tree/ast.h"

namespace proskill::syntax {

/// Moves every range `by` bytes towards the end of the text.
void shift(Range& range, Offset by);
void shift(FormNode& node, Offset by);
void shift(ReadForm& form, Offset by);
/// Moves every location of a diagnostic.
void shift(Diagnostic& diagnostic, Offset by);

} // namespace proskill::syntax
