#pragma once

#include "syntax/ast.h"
#include "syntax/diagnostic.h"

namespace proskill::syntax {

/// Moves every range of a form `by` bytes towards the end of the text.
void shift(Form& form, Offset by);
/// Moves every location of a diagnostic.
void shift(Diagnostic& diagnostic, Offset by);

} // namespace proskill::syntax
