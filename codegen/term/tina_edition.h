#pragma once

#include "codegen/model.h"

namespace proskill::codegen {

/// Removes the processes that have no `from`, of which no public source says that frac takes them.
/// What properties say of them is said of the state that they never leave.
void removeIdleProcesses(fiacre::Program& program);

/// Writes sums, comparisons and assignments of ranges so that both sides are of one type, by `$`,
/// and so that nothing on the way lies outside of its type: sums of several numbers are made of
/// `int`. frac gives a range no type but its own.
void coerceNumbers(fiacre::Program& program);

} // namespace proskill::codegen
