#pragma once

#include "fiacre/syntax/tree.h"

namespace proskill::test {

/// A model without what its text does not tell: comments, origins, properties and operands that are
/// printed as comments, sequences within sequences, the grouping of `and` and of `or`.
[[nodiscard]] fiacre::Program canonical(fiacre::Program program);

} // namespace proskill::test
