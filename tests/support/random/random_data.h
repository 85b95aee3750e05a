#pragma once

#include "fiacre/syntax/tree.h"
#include "tests/support/random/random_source.h"

namespace proskill::test {

[[nodiscard]] fiacre::Expr negation(fiacre::Expr operand);

/// Adds variables of compound types, whose uses never fail.
void addRandomData(fiacre::Program& program, fiacre::Component& component);
/// A test of that data.
[[nodiscard]] fiacre::Expr randomDataTest(RandomSource& random);
/// A change of that data that cannot fail.
[[nodiscard]] fiacre::Statement randomDataChange(RandomSource& random);

} // namespace proskill::test
