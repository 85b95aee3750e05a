#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// The function that returns whether a running skill has a false invariant that it has not noticed
/// yet; nothing if no skill has an invariant.
[[nodiscard]] std::optional<fiacre::Function> invariantActive(Context& context);

/// A call of this function; false if there is none.
[[nodiscard]] fiacre::Expr someInvariantFails(const Context& context);

} // namespace proskill::codegen
