#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// What a trace shows of a state: state variables, each skill's status and, where it is read, its
/// result, and how much of each resource is in use.
[[nodiscard]] std::vector<fiacre::Watched> watchedVariables(Context& context);

} // namespace proskill::codegen
