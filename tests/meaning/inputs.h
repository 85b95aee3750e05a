#pragma once

#include "tests/meaning/script.h"

namespace proskill::meaning {

/// Finds the inputs of skills that matter in the program, and where they are read.
void findInputs(Script& script);

} // namespace proskill::meaning
