#pragma once

#include "fiacre/syntax/tree.h"

#include <cstdint>

namespace proskill::test {

/// A small well-typed Fiacre program with every kind of interval, shared and local variables,
/// ports, tags, a record array and a function. Its properties cover each state of each instance,
/// each tag, some values, deadlocks and progress. The same seed gives the same program.
[[nodiscard]] fiacre::Program randomModel(std::uint64_t seed);

/// The same with a queue, a union with values, a variable index, values over a port, loops in
/// processes, priorities between ports and `unless`.
[[nodiscard]] fiacre::Program randomModelWithData(std::uint64_t seed);

/// Either of these with an observer and a nested composition: two processes observe states and
/// steps through probes. Its properties cover their states, too.
[[nodiscard]] fiacre::Program randomModelWithObserver(std::uint64_t seed);

} // namespace proskill::test
