#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// The function that tells whether a failed invariant of a running skill still waits to be noticed;
/// nothing where no skill has an invariant.
[[nodiscard]] std::optional<fiacre::Function> invariantActive(Context& context);

/// A call of it; false where there is none.
[[nodiscard]] fiacre::Expr someInvariantFails(const Context& context);

} // namespace proskill::codegen
