#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// The variables that a trace shows: state variables, each skill's status, its result if something
/// reads it, and how much of each resource is in use.
[[nodiscard]] std::vector<fiacre::Watched> watchedVariables(Context& context);

} // namespace proskill::codegen
