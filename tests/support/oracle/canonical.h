#pragma once

#include "fiacre/syntax/tree.h"

namespace proskill::test {

/// Removes what the text of a model does not determine: comments, origins, properties and operands
/// printed as comments, nested sequences, the grouping of `and` and of `or`.
[[nodiscard]] fiacre::Program canonical(fiacre::Program program);

} // namespace proskill::test
