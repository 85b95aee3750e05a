#pragma once

#include "codegen/process/component.h"

namespace proskill::codegen {

/// Adds the default properties of every part of the program, then the program's own properties, to
/// `model.fiacre`.
/// \pre offline; the program was built
void addChecks(Context& context, Model& model);

} // namespace proskill::codegen
