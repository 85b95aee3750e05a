#pragma once

#include "codegen/model.h"

namespace proskill::codegen {

/// Removes processes without a `from`, because no public source says that frac accepts them.
/// Properties that refer to them are rewritten for the one state that they never leave.
void removeIdleProcesses(fiacre::Program& program);

/// Inserts `$` so that both sides of sums, comparisons and assignments of ranges have the same
/// type, and so that no intermediate value is outside of its type: sums of several numbers are
/// computed as `int`. frac gives a range no type but its own.
void coerceNumbers(fiacre::Program& program);

} // namespace proskill::codegen
