#pragma once

#include "fiacre/syntax/tree.h"

namespace proskill::codegen {

/// Adds comments to the statements of the model, from the descriptions of their origins.
void annotate(fiacre::Program& program, const fiacre::Provenance& provenance);

} // namespace proskill::codegen
