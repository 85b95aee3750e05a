#pragma once

#include "fiacre/syntax/tree.h"
#include "tests/support/random/random_source.h"

namespace proskill::test {

/// The observable of an instance's state in a property.
[[nodiscard]] fiacre::Observable stateOf(std::uint32_t instance, std::string state);

/// Adds a component that observes the main one through probes, and properties of its states.
/// \pre the program has properties
void addRandomObserver(RandomSource& random, fiacre::Program& program);

} // namespace proskill::test
