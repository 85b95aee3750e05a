#pragma once

#include "codegen/model.h"

namespace proskill::test {

/// A runtime model with a platform around it, as one that can be verified: tasks return at any tick
/// of their intervals with any outcome, or at once when they are told to stop, and every event and
/// interrupt comes at any time. `program` is what the model was made from.
[[nodiscard]] fiacre::Program withPlatform(const codegen::Model& runtime,
                                           const analysis::Program& program);

} // namespace proskill::test
