#pragma once

#include "codegen/process/component.h"

namespace proskill::codegen {

/// Adds the default properties of every part of the program, then the program's own properties, to
/// `model.fiacre`.
/// \pre the model is to be verified; the program was built
void addChecks(Context& context, Model& model);

/// Adds only the program's own properties. \pre the program was built
void addProperties(Context& context, Model& model);

} // namespace proskill::codegen
