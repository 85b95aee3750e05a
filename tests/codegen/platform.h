#pragma once

#include "codegen/model.h"

namespace proskill::test {

/// A runtime model with a platform around it, for verification. Tasks return at any tick of their
/// intervals with any outcome, or at once when asked to stop; every event and interrupt comes at
/// any time. `program` is the program of the model.
[[nodiscard]] fiacre::Program withPlatform(const codegen::Model& runtime,
                                           const analysis::Program& program);

} // namespace proskill::test
