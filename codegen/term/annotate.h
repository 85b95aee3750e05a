#pragma once

#include "fiacre/syntax/tree.h"

namespace proskill::codegen {

/// Writes what a statement means in the program behind it, as a comment, from its origin's words.
void annotate(fiacre::Program& program, const fiacre::Provenance& provenance);

} // namespace proskill::codegen
